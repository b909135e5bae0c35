/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_CHECK_H
#define REDCC_CHECK_H

#include "plan/plan.h"

/**
 * Checks that the plan executes every iteration in the right threads, the right number of times,
 * and in the order that the method promises. Builds with assertions check every plan. The check
 * iterates over the access summaries again, and allocates no memory.
 *
 *     LOCALWRITE  each owner's schedule consists of the iterations that touch its elements, in the
 *                 order of the loop, owner-checked if they also touch elements of others
 *     levels      each thread's schedule is its share of each stage
 *     any other   each iteration (or each that touches an element) is in one schedule, once
 *
 * The last rule is checked by comparing the number of iterations, their sum, and their sum of
 * squares.
 */
bool redcc_plan_is_right(const struct plan *plan, const struct evidence *evidence);

#endif
