/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Decides which executors prefetch the accesses of later iterations (redcc/prefetch.h), and how far
 * ahead. To find the addresses, the executor evaluates the slice once more. That is cheap compared
 * with a long iteration. Compared with a short one it is cheap only if the iteration mostly waits
 * for memory. A static estimate decides whether prefetches are compiled; the runtime measures
 * whether they pay.
 *
 * Why it is sound: a prefetch changes no value and cannot fail, and the inspector evaluates the
 * same slice. Floating-point arithmetic sets no errno. But a slice marked has_floating_work may
 * call a mathematical function, which may set errno where the loop does not. So no slice with this
 * mark is evaluated for prefetches.
 */
#ifndef PLAN_PREFETCH_H
#define PLAN_PREFETCH_H

#include "plan/plan.h"

/** Sets plan->prefetch. plan_execution must have been called. */
void plan_prefetch(loop_plan *plan);

#endif
