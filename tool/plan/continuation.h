/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * May the original loop continue at an iteration that leaves it?
 *
 * The dry run finds the first iteration that leaves the loop (analysis/base/loop_exits.h). The
 * iterations before it run in parallel. Then the original loop continues, so the user's own text
 * makes the iteration that leaves:
 *
 *     if (redcc__done) { t = redcc__lower + redcc__made; }
 *     if (redcc__done && redcc__made == redcc__trip) { } else
 *     for (redcc__done ? (void)0 : (void)(t = 0); t < n; t++)
 *         { if (list[t] < 0) break; h[list[t]] += w[t]; }
 *
 * For this, every variable must have its value at the beginning of that iteration. Counter and
 * induction variables are computed. Sums, arrays and live-out variables are complete. Any other
 * private variable is written before it is read, except that the branch of the exit may read it.
 */
#ifndef PLAN_CONTINUATION_H
#define PLAN_CONTINUATION_H

#include "analysis/base/facts.h"

enum { MOST_CONTINUED = 6 };

/** A part of a `for` loop's first clause that is left out when the loop continues. */
typedef struct continued_part {
    ir_range range;     /* the text of an initialiser, or of the whole clause */
    int private_number; /* the initialised variable's number; CONTINUED_COUNTER, CONTINUED_CLAUSE */
} continued_part;
enum { CONTINUED_COUNTER = -1, CONTINUED_CLAUSE = -2 };

/** Lists the parts, in the order of the text. False: a macro makes one of them, or it has braces.
 */
bool continued_parts(const loop_facts *facts, continued_part parts[MOST_CONTINUED],
                     unsigned *count);

/** May the loop continue? */
bool may_continue_at_exits(const loop_facts *facts);

#endif
