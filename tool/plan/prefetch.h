/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Decides which executors prefetch the accesses of later iterations (redcc/prefetch.h), and how far
 * ahead. This evaluates the slice once more, which is cheap compared with a long iteration; for a
 * light one it is cheap only if that waits for memory all the time. A static estimate decides what
 * is compiled; the runtime measures whether it pays.
 *
 * A prefetch changes no value and cannot fail. The slice is evaluated by the inspector as well. A
 * slice with floating-point work might set errno where the loop does not, so such slices are not
 * evaluated for prefetches.
 */
#ifndef PLAN_PREFETCH_H
#define PLAN_PREFETCH_H

#include "plan/plan.h"

/** Sets prefetch, for the form whose slice is a separate function. */
void plan_prefetch(loop_plan *plan);

#endif
