/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Decides which loops have a form that executes several iterations at once, each in a lane
 * (redcc/lanes.h), and how their statements are executed in it.
 *
 * A body is split into computations, which are executed for all lanes at once, and updates, which
 * are executed iteration by iteration after them. Why it is sound: no iteration reads what another
 * one updates; otherwise the loop could not run in parallel. No statement after an update in the
 * body changes the update's operands. Each element gets its updates in the order of the loop.
 */
#ifndef PLAN_LANES_H
#define PLAN_LANES_H

#include "plan/lane_class.h"

/** Returns the reason why the loop has no lanes, as far as it is known before the body is analysed.
 * LANES_NOT_ASKED: none are requested. LANES_WRITTEN: no reason is known yet. */
lane_reason plan_lanes(const loop_plan *plan);

/** Does the `for` initialise the variable? */
bool lane_begins_with(const ir_node *loop, const ir_variable *variable);
/** Are all uses of the variable within loops that initialise it? Then the order of two such loops
 *  does not matter. */
bool lane_is_counter_only(const ir_node *node, const ir_variable *variable);
/** Does the node name or declare the variable? */
bool lane_mentions(const ir_node *node, const ir_variable *variable);
/** Does the statement contain an update? */
bool lane_has_update(const loop_facts *facts, const ir_node *statement);
/** Is the statement `if (...) continue;`? */
bool lane_is_exit(const ir_node *statement);
/** Given a statement with updates: is it an `if` without `else` whose block also contains
 * statements without updates? */
bool lane_is_part(const loop_facts *facts, const ir_node *statement);

/** The update statement of the body that contains the node, or NULL if the node is computed for all
 * lanes at once. */
const ir_node *lane_updating(const lane_scope *l, const ir_node *node);

/** Records a problem if too much of an iteration's work is done lane by lane, in update statements
 * and in calls. Does nothing if lanes are requested for all loops. */
void lane_check_worth(lane_scope *l);

/** An update statement is executed once for each lane. Records a problem if a jump leaves it, or if
 * it changes anything but the element and variables private to the lane. */
void lane_check_updates(lane_scope *l, const ir_node *statement);
/** Updates are deferred. Records a problem if a later statement of the block changes an
 * update's operands, or uses a variable that the update statement changes. */
void lane_check_order(lane_scope *l, const ir_node *block);
/** Records a problem if the value cannot become an integer or a pointer per lane. */
void lane_check_operand(lane_scope *l, const ir_node *value);

/** Are the iterations of an inner `for` the same for all lanes? */
bool lane_loop_is_uniform(lane_scope *l, const ir_node *loop);
/** May the function, at this call depth, get a vector form? It must belong to this file, have fixed
 * parameters, and return nothing, or a double or float at its end. */
bool lane_can_be_called(const ir_function *function, const ir_node *call, unsigned depth);
/** The class of the parameter in a call with this argument. Records a problem if there is none. */
lane_class lane_parameter_class(lane_scope *l, const ir_variable *parameter, const ir_node *value);
/** The innermost element type of a LANE_VECTOR variable; of a pointer, that of its target. */
const ir_type *lane_vector_type(const ir_variable *variable);

#endif
