/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Is the loop's body, executed in order, the sequential loop? The executor reads bounds and copies
 *  of variables once, and stores an iteration's own elements when all iterations have ended. */
#ifndef PLAN_IN_ORDER_H
#define PLAN_IN_ORDER_H

#include "analysis/base/facts.h"

/** May an update change a value that the executor reads before the loop, or keeps until its end? */
bool has_values_from_before(const loop_facts *facts);

/** Given that no update may do that: is the body in order the loop, from any iteration on, and are
 *  iterations heavy? Then the first ones may be timed (runtime/src/beginning.h). */
bool may_begin_in_order(const loop_facts *facts);

#endif
