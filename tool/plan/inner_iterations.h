/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Iterations of an inner loop that are not the thread's part. In the guarded form of
 *
 *     for (k = 0; k < n[i]; k++) {
 *         j = list[i][k];
 *         ... much work ...
 *         f[i] += e; f[j] -= e;
 *     }
 *
 * a thread that owns neither f[i] nor f[j] need not do the work: as soon as j is known, it goes on
 * to the next inner iteration. Rows that a loop below steps through one after the other are asked
 * for together: of a loop over pairs of blocks, a thread that owns neither block goes on to the
 * next.
 *
 * Why it is sound: the rest of the inner iteration does nothing but updates, and changes no
 * variable but its own, so that nobody can see whether the thread executed it; and the rows that it
 * updates can be named before it. It may also add to variables that only updates outside of the
 * inner loop read, as in `p += e; ... f[i] += p;`: then the thread must not own their rows either.
 * What it adds to series, and errno, which a mathematical function in it may set, are those of the
 * thread that leads in the iteration.
 */
#ifndef PLAN_INNER_ITERATIONS_H
#define PLAN_INNER_ITERATIONS_H

#include "plan/plan.h"

enum { MOST_SKIP_ROWS = 8 };

/** Rows that an inner iteration updates. */
typedef struct skip_row {
    const reduction_update *update; /* one of them */
    const loop_span *span; /* the loop below that steps through them; NULL: it is one row */
} skip_row;

/** An inner loop, whose iterations are left out by threads that own none of the rows. */
typedef struct inner_skip {
    const ir_node *loop;
    const char *declined;  /* why none is left out; NULL: */
    const ir_node *before; /* the statement of the body in front of which ownership is checked */
    bool needs_leader; /* what is left out adds to series, or may set errno: the thread that leads
                          in an iteration leaves nothing out */
    unsigned row_count;
    skip_row rows[MOST_SKIP_ROWS];
} inner_skip;

/** Sets skips: of the form whose body is a function of its own. */
void plan_inner_skips(loop_plan *plan);

/** Must one of the threads that execute an iteration go through all of it? */
bool plan_has_leaders(const loop_plan *plan);

/** What the plan says of this inner loop; NULL: nothing of it is left out. */
const inner_skip *skip_of(const loop_plan *plan, const ir_node *loop);

#endif
