/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Calls of the C library in the iterations of several lanes. What vectors have no form for is
 * called lane by lane, in the place of the call: its bits are the library's, whatever the order of
 * calls. errno is what the order matters to: the loop leaves it as the last failing call does.
 * Lanes make a call for all iterations before the next call, and those beside updates last. So
 * either calls can fail in one way only, or one call an iteration can fail, or those beside updates
 * alone.
 */
#ifndef PLAN_LANE_CALLS_H
#define PLAN_LANE_CALLS_H

#include "plan/lane_class.h"

/** What a call costs that is made lane by lane, in operations. */
enum { LANE_CALL_WORK = 40 };

/** May the call be made lane by lane? It is of a function of the C library, of doubles or floats.
 */
bool lane_may_call(const ir_unit *unit, const ir_node *call);

/** Has it a form for vectors? Its name, NULL: none. */
const char *lane_known_call(const ir_function *callee);

/** Records a problem where errno may be left with another value. */
void lane_check_errors(lane_scope *l);

/** Calls an iteration that are made lane by lane, those beside updates left out. */
int64_t lane_count_calls(const lane_scope *l);

#endif
