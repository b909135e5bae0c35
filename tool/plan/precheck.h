/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The dependence pre-check. The inspector reads before the loop what the loop reads in its course:
 * in
 *
 *     h[s[t]] += f(t);
 *     g[map[k[t]]] += 1;
 *
 * it reads map[k[t]] with the k[t] of before the loop. Where k overlaps h, the guard finds that
 * out, but k[t] may be no subscript of map until an earlier iteration has made it one.
 *
 * So, where the analysis cannot prove that they are disjoint and unverified values would do harm
 * (unverified.h), one thread first logs all iterations in order. It stops at the first update of
 * what the loop reads, as far as that is known, or at the first read of what the loop has updated.
 * Up to there each value is that of the sequential loop. What is read before the first iteration
 * has no such check; such a loop is left alone.
 *
 * Where an iteration may leave the loop (loop_exits.h), the same run finds it: it ends at the first
 * iteration that does, and no later one is looked at.
 */
#ifndef PLAN_PRECHECK_H
#define PLAN_PRECHECK_H

#include "plan/plan.h"

/** Sets precheck, or records an obstacle where that would not do. */
void plan_precheck(loop_plan *plan);

#endif
