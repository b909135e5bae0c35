/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Calls of the C library in iterations executed as lanes. A function without a vector form is
 * called lane by lane, at the place of the call. The results have the library's bits, whatever the
 * order of the calls. The order affects only errno, which keeps the value of the last call that
 * fails. Lanes make each call for all iterations before they make the next call. Calls in update
 * statements come last. So lanes are allowed in three cases: all calls fail in the same way; at
 * most one call per iteration can fail; or only calls in update statements can fail.
 */
#ifndef PLAN_LANE_CALLS_H
#define PLAN_LANE_CALLS_H

#include "plan/lane_class.h"

/** Cost of a call made lane by lane, in operations. */
enum { LANE_CALL_WORK = 40 };

/** May the call be made lane by lane? Its callee must be a known function of the C library that
 * takes and returns doubles or floats. */
bool lane_may_call(const ir_unit *unit, const ir_node *call);

/** The callee's name if it has a vector form in redcc/lanes.h (sqrt, fabs, sqrtf,
 *  fabsf), or NULL. */
const char *lane_known_call(const ir_function *callee);

/** Records a problem if errno may have another value after the loop than after the sequential
 * loop. */
void lane_check_errors(lane_scope *l);

/** The number of calls per iteration that are made lane by lane, except for those in update
 * statements. */
int64_t lane_count_calls(const lane_scope *l);

#endif
