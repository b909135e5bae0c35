/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_CHECK_H
#define REDCC_CHECK_H

#include "plan/plan.h"

/**
 * Is every iteration executed by whom it should be, as often as it should be, and in the order that
 * the method promises? Builds with assertions ask it of every plan; the inspection's evidence is
 * walked anew, and takes no memory.
 *
 *     LOCALWRITE  each owner's schedule is the iterations that touch what it owns, in the order of
 *                 the loop, guarded where they touch others' too
 *     levels      each thread's schedule is its share of each level
 *     any other   each iteration, or each that touches something, is in one schedule, once
 */
bool redcc_plan_is_right(const struct plan *plan, const struct evidence *evidence);

#endif
