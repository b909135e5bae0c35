/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops whose arrays OpenMP's clause `reduction` names with their sections. The clause permits any
 * order, and names all elements that are updated. So without an inspection the iterations are
 * divided into N shares. The first updates the arrays, each later one a copy, and the copies are
 * merged in order. N follows from the loop, its trip count, the size of the sections and
 * REDCC_MEMORY_LIMIT, never from threads, time or free memory: all executions give the same bits.
 * Only the number of threads is learned.
 */
#ifndef REDCC_CHOOSE_SECTIONS_H
#define REDCC_CHOOSE_SECTIONS_H

#include "base/call.h"
#include "learn/paired_timing.h"
#include "plan/plan.h"

enum { SECTION_SIZES = 16 };

/** Of a loop; initially zero. */
struct sections {
    struct plan *plan[2]; /* the last plan for one thread, and for several */
    struct paired_timing
        pace[SECTION_SIZES]; /* of several threads (arm 0), and of one; by trip count */
    bool met[SECTION_SIZES]
            [2]; /* have several threads, has one executed it once? Then threads and copies exist */
    unsigned rest[SECTION_SIZES]; /* calls since the last comparison of the two */
};

/** The number of shares; below 2: the order is that of the loop. */
int redcc_sections_shares(const redcc_loop *loop, redcc_int trip, void *const *bases,
                          const redcc_extent *sections, size_t memory_limit);

/** The number of threads that execute the shares: `threads`, or one if faster or on trial. */
int redcc_sections_threads(struct sections *it, redcc_int trip, int threads);

/** Records the time that `threads` threads took. */
void redcc_sections_timed(struct sections *it, redcc_int trip, int threads, double seconds);

/** The plan for call->threads threads and call->parameter shares; NULL: no memory. */
struct plan *redcc_sections_plan(struct sections *it, const struct call *call);

/** Frees the plans. */
void redcc_sections_end(struct sections *it);

#endif
