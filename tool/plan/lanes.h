/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Several iterations at once (redcc/lanes.h): which loops have such a form, and which statements.
 *
 * A body is taken apart into what computes, for all lanes, and what updates, iteration by
 * iteration. Why it is sound: no iteration reads what another one updates, or the loop could not
 * run in parallel, so that the updates may come last; each element gets them in the order of the
 * loop, lane by lane; and nothing that comes below an update in the body changes what the update
 * reads.
 */
#ifndef PLAN_LANES_H
#define PLAN_LANES_H

#include "plan/lane_class.h"

/** Why the loop has no such form, or that it is not to have one, as far as it is known before its
 * body is gone through. */
lane_reason plan_lanes(const loop_plan *plan);

/** Does the `for` give the variable its first value? */
bool lane_begins_with(const ir_node *loop, const ir_variable *variable);
/** Is each mention of the variable within a `for` that gives it its first value? */
bool lane_is_counter_only(const ir_node *node, const ir_variable *variable);
/** Is the variable named, or declared, in the node? */
bool lane_mentions(const ir_node *node, const ir_variable *variable);
/** Does the statement hold an update? */
bool lane_has_update(const loop_facts *facts, const ir_node *statement);
/** Is it `if (...) continue;`? */
bool lane_is_exit(const ir_node *statement);
/** Is it an `if` that computes and updates? */
bool lane_is_part(const loop_facts *facts, const ir_node *statement);

/** The statement of the body that updates and holds the node; NULL: it is computed for all lanes.
 */
const ir_node *lane_updating(const lane_scope *l, const ir_node *node);

/** Records a problem where what each lane does beside its updates outweighs what vectors compute,
 *  unless all loops are to have lanes. */
void lane_check_worth(lane_scope *l);

/** Records a problem where a statement that updates changes anything but elements and counters, or
 * jumps: it is executed once for each lane; */
void lane_check_updates(lane_scope *l, const ir_node *statement);
/** where a statement of the block changes what an update above it reads. */
void lane_check_order(lane_scope *l, const ir_node *block);
/** Records a problem where the value cannot become an integer or a pointer of each lane. */
void lane_check_operand(lane_scope *l, const ir_node *value);

/** Are the iterations of an inner `for` the same for all lanes? */
bool lane_loop_is_uniform(lane_scope *l, const ir_node *loop);
/** May the function, so many calls deep, be written for vectors? It must return at its end. */
bool lane_can_be_called(const ir_function *function, const ir_node *call, unsigned depth);
/** Of what class is the parameter, with this argument? */
lane_class lane_parameter_class(lane_scope *l, const ir_variable *parameter, const ir_node *value);
/** The element of a variable of vectors: of a pointer, what it points to. */
const ir_type *lane_vector_type(const ir_variable *variable);

#endif
