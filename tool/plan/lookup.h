/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Questions that the facts of a loop answer: what a node or a variable is to it. */
#ifndef PLAN_LOOKUP_H
#define PLAN_LOOKUP_H

#include "analysis/base/facts.h"

/** The array whose base this node says, or -1. */
int loop_array_of_base(const loop_facts *facts, const ir_node *node);
/** The first update that this statement makes, or NULL. */
const reduction_update *loop_update_at(const loop_facts *facts, const ir_node *statement);
/** The stored value, read again in the iteration, that this statement makes, or NULL. */
const forwarded_store *forward_stored_by(const loop_facts *facts, const ir_node *statement);
/** The number of the iteration's own element that this node names, or -1. */
int own_element_at(const loop_facts *facts, const ir_node *node);
/** The number of the scalar update that is this statement, or -1. */
int scalar_update_at(const loop_facts *facts, const ir_node *statement);
/** Are there scalars of which each iteration keeps a series of operands? */
bool has_series(const loop_facts *facts);
/** The first update of the scalar that this one updates: by its number a series is named. */
unsigned series_of(const loop_facts *facts, unsigned number);
/** The inner loop, where the slice logs its rows at once; or NULL. */
const loop_span *span_of(const loop_facts *facts, const ir_node *loop);
/** The increment at the end of a while or do loop's body, which is the executor's own: copies of
 * the body do not have it. NULL: there is none. */
const ir_node *body_increment(const loop_facts *facts);

/** Is it the iteration's own, or declared in the body? */
bool is_declared_in(const loop_facts *facts, const ir_variable *variable);
/** Is it one that the loop only reads? */
bool is_captured(const loop_facts *facts, const ir_variable *variable);
/** Has each thread a copy of its own? */
bool is_copied_in(const ir_variable *variable);
/** Is the counter another variable than the loop's own, with a value after it that is wanted? */
bool counter_outlives(const loop_facts *facts);
/** Are there private variables whose last value is wanted: of those that each iteration assigns; of
 * those that only some do? */
bool has_live_outs(const loop_facts *facts);
bool has_conditional_live_outs(const loop_facts *facts);
/** Does it leave variables that it assigns or steps? */
bool leaves_variables(const loop_facts *facts);
/** Does it leave more than its updates of arrays: such variables, or scalars? */
bool leaves_values(const loop_facts *facts);
/** The number of the private variable, assigned by some iterations only and wanted after the loop,
 * that this statement assigns; or -1. */
int conditional_live_out_of(const loop_facts *facts, const ir_node *statement);

#endif
