/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Looks up nodes and variables in the facts of a loop. */
#ifndef PLAN_LOOKUP_H
#define PLAN_LOOKUP_H

#include "analysis/base/facts.h"

/** The number of the array with this base, or -1. Arrays whose rows are reached through pointers in
 * memory (scattered) are not found. */
int loop_array_of_base(const loop_facts *facts, const ir_node *node);
/** The first update that this statement makes, or NULL. */
const reduction_update *loop_update_at(const loop_facts *facts, const ir_node *statement);
/** The forwarded store (read again in the same iteration) of this statement, or NULL. */
const forwarded_store *forward_stored_by(const loop_facts *facts, const ir_node *statement);
/** The number of the own element (one that no other iteration touches) that this node names, or
 * -1. */
int own_element_at(const loop_facts *facts, const ir_node *node);
/** The number of this statement's scalar update, or -1. */
int scalar_update_at(const loop_facts *facts, const ir_node *statement);
/** Are there scalars with a series of operands per iteration? */
bool has_series(const loop_facts *facts);
/** The number of the first update of the same scalar; it identifies the series. */
unsigned series_of(const loop_facts *facts, unsigned number);
/** The span of the inner loop, if the slice logs its rows as one range, or NULL if it does not. */
const loop_span *span_of(const loop_facts *facts, const ir_node *loop);
/** Do the inner loop's first and last iterations have the extreme addresses of its updates? */
bool has_hull(const loop_facts *facts, const ir_node *loop);
/** Returns the increment that is a statement at the end or beginning of the loop's body. The
 * executor makes this increment itself, so copies of the body omit it. Returns NULL if there is
 * none. */
const ir_node *body_increment(const loop_facts *facts);

/** Is the variable private to the iteration, or declared in the body? */
bool is_declared_in(const loop_facts *facts, const ir_variable *variable);
/** Does the loop only read the variable, which is declared outside of it? */
bool is_captured(const loop_facts *facts, const ir_variable *variable);
/** May each thread copy the captured variable, to keep it in a register? True only for scalars, and
 * for small structs of a fixed size whose address is never taken. */
bool is_copied_in(const ir_variable *variable);
/** Is the counter declared outside of the loop, and live-out? */
bool counter_outlives(const loop_facts *facts);
/** has_live_outs: are there live-out private variables that each iteration assigns?
 * has_conditional_live_outs: are there any that only some iterations assign? */
bool has_live_outs(const loop_facts *facts);
bool has_conditional_live_outs(const loop_facts *facts);
/** Does the loop have live-out variables, or variables that are stepped by a constant per
 * iteration? */
bool leaves_variables(const loop_facts *facts);
/** Does the loop have results other than updates of arrays: live-out or stepped variables,
 * scalars, or own elements? */
bool leaves_values(const loop_facts *facts);
/** The number of the conditional lastprivate variable that this statement assigns; or -1. */
int conditional_live_out_of(const loop_facts *facts, const ir_node *statement);

#endif
