/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Iterations in levels, such that two which touch a common unit are in levels in their order:
 *
 *     level(t) = 1 + max { level(s) : s < t, s and t touch a common unit },  0 where there is none
 *
 * Iterations of one level touch nothing in common and may be executed at once. Levels of few
 * iterations are not worth a barrier each: consecutive ones of that kind make one stage, executed
 * by one thread in the order of the loop; any other level is a stage of its own. (Saltz,
 * Mirchandaney, Crowley, Run-time parallelization and scheduling of loops, 1991, call the levels
 * wavefronts.)
 */
#ifndef REDCC_LEVELS_H
#define REDCC_LEVELS_H

#include "ownership/graph/told.h"

/** The iterations of one stage: iteration[begin] up to the next stage's. */
struct level_stage {
    uint32_t begin;
    bool alone; /* for one thread */
};

struct levels {
    uint32_t *iteration;       /* [count] by stages, ascending within each */
    struct level_stage *stage; /* [stages + 1] */
    uint32_t count;
    uint32_t stages;
    uint32_t levels; /* before few of them were put together */
};

/** Puts all iterations that told [threads] tells in levels; those that touch nothing are left out,
 *  but for the last one, or (every) come first. At most REDCC_BLOCK iterations. False: no memory
 *  (end it all the same). */
bool redcc_levels_begin(struct levels *levels, const struct told *told, int threads, bool every);

/** Gives back its memory. */
void redcc_levels_end(struct levels *levels);

/** What one thread executes of stage `stage`: iteration[*first] ... iteration[*end - 1]. */
void redcc_levels_share(const struct levels *levels, uint32_t stage, int threads, int thread,
                        uint32_t *first, uint32_t *end);

/** How long `threads` threads take, in iterations, a barrier being as long as some hundred. */
double redcc_levels_length(const struct levels *levels, int threads);

#endif
