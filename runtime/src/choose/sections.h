/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops with an OpenMP clause `reduction` that names sections of their arrays. The clause permits
 * any order, and names all elements that are updated. So no inspection is needed. The iterations
 * are divided into N shares. The first share updates the arrays, each later share updates a copy,
 * and the copies are merged in order. N depends on the loop, its trip count, the size of the
 * sections and REDCC_MEMORY_LIMIT, but never on threads, time or free memory. So all executions
 * give the same bits. Only the number of threads is learned.
 */
#ifndef REDCC_CHOOSE_SECTIONS_H
#define REDCC_CHOOSE_SECTIONS_H

#include "base/call.h"
#include "learn/paired_timing.h"
#include "plan/plan.h"

enum { SECTION_SIZES = 16 };

/** The state of a loop with sections; initially zero. */
struct sections {
    struct plan *plan[2]; /* the last plan for one thread, and the last plan for several threads */
    struct paired_timing pace[SECTION_SIZES]; /* by trip count: times of several threads (arm 0) and
                                                 of one thread (arm 1) */
    bool met[SECTION_SIZES]
            [2]; /* was it run by several threads (0), by one (1)? Then the memory for it exists */
    unsigned rest[SECTION_SIZES]; /* number of calls since several threads and one thread were last
                                     compared */
};

/** The number of shares. If it is below 2, the loop is executed in its own order. */
int redcc_sections_shares(const redcc_loop *loop, redcc_int trip, void *const *bases,
                          const redcc_extent *sections, size_t memory_limit);

/** The number of threads that shall execute the shares: `threads`; or one, if one thread is faster
 * or is being tried. */
int redcc_sections_threads(struct sections *it, redcc_int trip, int threads);

/** Records the time that `threads` threads took. */
void redcc_sections_timed(struct sections *it, redcc_int trip, int threads, double seconds);

/** The plan for call->threads threads and call->parameter shares. NULL: out of memory. */
struct plan *redcc_sections_plan(struct sections *it, const struct call *call);

/** Frees the plans. */
void redcc_sections_end(struct sections *it);

#endif
