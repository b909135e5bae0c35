/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Skipping iterations of an inner loop that do not concern the thread. In the owner-checked form of
 *
 *     for (k = 0; k < n[i]; k++) {
 *         j = list[i][k];
 *         ... much work ...
 *         f[i] += e; f[j] -= e;
 *     }
 *
 * a thread that owns neither f[i] nor f[j] need not do the work: as soon as j is known, it
 * continues with the next inner iteration. Rows that a nested loop steps through are checked
 * together: in a loop over pairs of blocks, a thread that owns neither block skips the pair.
 *
 * Why it is sound: the rest of the inner iteration only makes updates and changes its private
 * variables. Among these are variables declared outside that are set again before each use
 * (inner_variables.h). So skipping the rest cannot be observed. The rows that the rest updates are
 * known before it. The rest may also add to variables that are read only by updates outside of the
 * inner loop, as in `p += e; ... f[i] += p;`: then a thread that skips the rest must not own the
 * rows of those updates either. If the rest adds to series, or may set errno, one thread leads in
 * each iteration and skips nothing.
 */
#ifndef PLAN_INNER_ITERATIONS_H
#define PLAN_INNER_ITERATIONS_H

#include "plan/plan.h"

enum { MOST_SKIP_ROWS = 8 };

/** Rows that an inner iteration updates. */
typedef struct skip_row {
    const reduction_update *update; /* an update that changes them */
    const loop_span *span; /* the nested loop that steps through them, or NULL if it is one row */
} skip_row;

/** An inner loop whose iterations are skipped by threads that own none of the rows. */
typedef struct inner_skip {
    const ir_node *loop;
    const char *declined;  /* the reason why nothing is skipped, or NULL if the following fields are
                            * set */
    const ir_node *before; /* the statement of the loop's body before which ownership is checked */
    bool needs_leader;     /* the skipped part adds to series, or may set errno: the thread that
                            * leads in an iteration skips nothing */
    unsigned row_count;
    skip_row rows[MOST_SKIP_ROWS];
} inner_skip;

/** Sets plan->skips: an entry for each inner loop, with the reason if nothing is skipped. */
void plan_inner_skips(loop_plan *plan);

/** Must one of the threads that execute an iteration, its leader, execute all of it? */
bool plan_has_leaders(const loop_plan *plan);

/** The plan's entry for this inner loop, or NULL if no part of it is skipped. */
const inner_skip *skip_of(const loop_plan *plan, const ir_node *loop);

#endif
