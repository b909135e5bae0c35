/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Decides which executors prefetch the accesses of later iterations (redcc/prefetch.h), and how far
 * ahead. To find the addresses, the executor evaluates the slice once more. That is cheap compared
 * with a long iteration. Compared with a short one it is cheap only if the iteration mostly waits
 * for memory. A static estimate decides whether prefetches are compiled; the runtime measures
 * whether they pay.
 *
 * Why it is sound: a prefetch changes no value and cannot fail, and the inspector evaluates the
 * same slice. A slice with floating-point work might set errno where the loop does not, so such
 * slices are not evaluated for prefetches.
 */
#ifndef PLAN_PREFETCH_H
#define PLAN_PREFETCH_H

#include "plan/plan.h"

/** Sets prefetch. Requires plan_execution. */
void plan_prefetch(loop_plan *plan);

#endif
