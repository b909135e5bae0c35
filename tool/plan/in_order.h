/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Does the executor's body, executed in order, do the same as the sequential loop? Not always: the
 *  executor reads bounds and variables once, before the loop, and stores own elements when all
 *  iterations have ended. */
#ifndef PLAN_IN_ORDER_H
#define PLAN_IN_ORDER_H

#include "analysis/base/facts.h"

/** May an update change a value that the executor reads before the loop, or stores only after
 * it? */
bool has_values_from_before(const loop_facts *facts);

/** Returns true if the iterations are long, and the body, executed in order, may replace the
 *  sequential loop from any iteration on. The first iterations may then be executed in order, and
 *  timed (runtime/src/beginning.h). Requires !has_values_from_before. */
bool may_begin_in_order(const loop_facts *facts);

#endif
