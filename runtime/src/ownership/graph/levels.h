/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Assigns iterations to levels, such that two iterations that touch a common unit are in different
 * levels, in their order:
 *
 *     level(t) = 1 + max { level(s) : s < t, s and t touch a common unit },  0 if there is none
 *
 * Iterations of one level touch nothing in common and may run concurrently. A barrier is too
 * expensive for a level of few iterations: consecutive ones of that kind form one stage, executed
 * by one thread in the order of the loop; any other level is a separate stage. (Saltz,
 * Mirchandaney, Crowley, Run-time parallelization and scheduling of loops, 1991, call the levels
 * wavefronts.)
 */
#ifndef REDCC_LEVELS_H
#define REDCC_LEVELS_H

#include "ownership/graph/access_log.h"

/** The iterations of one stage: iteration[begin] up to the next stage's. */
struct level_stage {
    uint32_t begin;
    bool alone; /* executed by one thread */
};

struct levels {
    uint32_t *iteration;       /* [count] sorted by stage, ascending within each */
    struct level_stage *stage; /* [stages + 1] */
    uint32_t count;
    uint32_t stages;
    uint32_t levels; /* number of levels before small ones were merged */
};

/** Assigns all iterations recorded in logged [threads] to levels. Iterations that touch nothing are
 *  left out, except for the last one; with `every` they are in level 0. At most REDCC_BLOCK
 *  iterations. False: out of memory. Call redcc_levels_end in either case. */
bool redcc_levels_begin(struct levels *levels, const struct access_log *logged, int threads,
                        bool every);

/** Frees its memory. */
void redcc_levels_end(struct levels *levels);

/** The share of a thread in stage `stage`: iteration[*first] ... iteration[*end - 1]. */
void redcc_levels_share(const struct levels *levels, uint32_t stage, int threads, int thread,
                        uint32_t *first, uint32_t *end);

/** The estimated time with `threads` threads, in iterations; a barrier counts as 200 of these. */
double redcc_levels_length(const struct levels *levels, int threads);

#endif
