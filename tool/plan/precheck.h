/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The dependence pre-check. The inspector reads before the loop what the loop reads while it runs.
 * For the loop body
 *
 *     h[s[t]] += f(t);
 *     g[map[k[t]]] += 1;
 *
 * the inspector reads map[k[t]] with the initial value of k[t]. If k overlaps h, the guard detects
 * that, but k[t] may be an invalid subscript of map until an earlier iteration has set it.
 *
 * So, if the analysis cannot prove that k and h are disjoint, and unverified values would be
 * harmful (unverified.h), one thread first logs all iterations in order. It stops at the first
 * update of a range that the loop is known to read, or at the first read of an updated element. Up
 * to that point each value is that of the sequential loop. Reads before the first iteration have no
 * such check; a loop that needs one is not transformed.
 *
 * If an iteration may leave the loop (loop_exits.h), the same run finds it: it ends at the first
 * iteration that does, and later ones are not inspected.
 */
#ifndef PLAN_PRECHECK_H
#define PLAN_PRECHECK_H

#include "plan/plan.h"

/** Sets precheck, or records an obstacle if a pre-check is not sufficient. */
void plan_precheck(loop_plan *plan);

#endif
