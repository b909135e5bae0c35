/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Which executors prefetch what iterations to come touch (redcc/prefetch.h), and how far ahead. The
 * slice is evaluated once more for it: little beside a long iteration; beside a light one, little
 * only where that waits for memory all the time. A static estimate decides what is compiled; the
 * runtime measures whether it pays.
 *
 * A prefetch changes no value and cannot fail. What is evaluated once more is the slice, which the
 * inspector evaluates as well; with floating-point work it might set errno where the loop does not,
 * so that such slices are not evaluated for it.
 */
#ifndef PLAN_PREFETCH_H
#define PLAN_PREFETCH_H

#include "plan/plan.h"

/** Sets prefetch: for the form whose slice is a function of its own. */
void plan_prefetch(loop_plan *plan);

#endif
