/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Assigns iterations to levels. If two iterations touch a common unit, the earlier one is in a
 * lower level:
 *
 *     level(t) = 1 + max { level(s) : s < t, s and t touch a common unit },  0 if there is none
 *
 * Iterations of one level touch nothing in common and may run concurrently. A barrier would be too
 * expensive for a level of few iterations. Therefore consecutive levels of few iterations form one
 * stage, which one thread executes in the order of the loop. Any other level is a separate stage.
 * (Saltz, Mirchandaney, Crowley, Run-time parallelization and scheduling of loops, 1991, call the
 * levels wavefronts.)
 */
#ifndef REDCC_LEVELS_H
#define REDCC_LEVELS_H

#include "ownership/graph/access_log.h"

/** A stage: the iterations from iteration[begin] to before the next stage's `begin`. */
struct level_stage {
    uint32_t begin;
    bool alone; /* one thread executes the stage */
};

struct levels {
    /* [count] the iterations, sorted by stage and ascending within each stage */
    uint32_t *iteration;
    struct level_stage *stage; /* [stages + 1] the stages and an end */
    uint32_t count;
    uint32_t stages;
    uint32_t levels; /* number of levels before small ones were merged */
};

/** Assigns all iterations recorded in logged[threads] to levels. Iterations that touch nothing are
 * in level 0 if `every` is set; otherwise they are left out, except for the loop's last iteration.
 * There may be at most REDCC_BLOCK iterations. Returns false if out of memory. Call
 * redcc_levels_end in either case. */
bool redcc_levels_begin(struct levels *levels, const struct access_log *logged, int threads,
                        bool every);

/** Frees the memory. */
void redcc_levels_end(struct levels *levels);

/** Computes the share of a thread in stage `stage`: iteration[*first] to iteration[*end - 1]. */
void redcc_levels_share(const struct levels *levels, uint32_t stage, int threads, int thread,
                        uint32_t *first, uint32_t *end);

/** The estimated time of an execution by `threads` threads, in units of an iteration's time. A
 * barrier counts as 200 iterations. */
double redcc_levels_length(const struct levels *levels, int threads);

#endif
