/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What the variables of an iteration are where several iterations are executed at once. Expressions
 * follow from the classes of what they mention. Control is the same for all lanes, but for
 * conditions around updates, which are made lane by lane.
 *
 * A variable is uniform as long as nothing that differs between lanes is assigned to it, and no
 * condition that differs decides whether it is assigned: the classes are spread over assignments
 * until nothing changes.
 */
#ifndef PLAN_LANE_CLASS_H
#define PLAN_LANE_CLASS_H

#include "plan/lane_reason.h"
#include "plan/plan.h"

typedef enum lane_class {
    LANE_UNIFORM, /* the same in all lanes: a scalar */
    LANE_VARYING, /* an integer or pointer of each lane: an array of them */
    LANE_MASK,  /* a constant integer that is a comparison of doubles or floats: a mask, -1 for 1 */
    LANE_LOCAL, /* declared beside updates: what each lane's updates hold for themselves */
    LANE_VECTOR /* a double or float, or an array of them, of each lane: vectors */
} lane_class;

/** What is written for vectors: the loop's body, or a function that it calls. */
typedef struct lane_scope {
    const loop_plan *plan;
    const ir_function *function; /* NULL: the loop's body */
    const ir_node *body;
    lane_class *class_of; /* by variable */
    ir_range place;       /* of the last statement that stands in the file itself */
    lanes_outcome *outcome;
} lane_scope;

/** Records why the scope cannot be written for vectors, unless there is a reason already; `node`:
 * what stands in the way; NULL: the place kept. */
void lane_problem(const lane_scope *l, lane_reason why, const ir_node *node);
/** Keeps the place of what is being written. */
void lane_note_place(lane_scope *l, const ir_node *node);

/** Gives each variable of the scope its class. Parameters of a function have theirs already. */
void lane_classify(lane_scope *l);

/** Is it a variable of the iteration, or of the function being written? */
bool lane_is_own(const lane_scope *l, const ir_variable *variable);
bool lane_is_uniform(const lane_scope *l, const ir_node *node);
/** No call, no assignment in it. */
bool lane_is_plain(const ir_node *node);
/** Is a lane_value variable mentioned other than for one of its elements? */
bool lane_has_whole_vector(const lane_scope *l, const ir_node *node);
bool lane_mentions_vector(const lane_scope *l, const ir_node *node);
/** The lane_value variable whose element or value this is, the same one in all lanes, or NULL. */
const ir_variable *lane_vector_root(const lane_scope *l, const ir_node *node);
/** The same where each lane may have another element: its subscripts are integers of the lane. */
const ir_variable *lane_vector_element(const lane_scope *l, const ir_node *node);
/** A double or a float: what has vectors. */
bool lane_is_real(const ir_type *type);
/** May it be evaluated where the program does not? */
bool lane_is_safe(const lane_scope *l, const ir_node *node);
/** Is it one of the arithmetic operators of vectors, + - * and /? */
bool lane_has_operator(ir_operator op);
/** Why an operand that is not plain is none. */
lane_reason lane_effect_of(const ir_node *node);
/** The type in which an operator computes: double where one operand is, else float; NULL where
 *  neither is any of these, or one is no number of lanes. */
const ir_type *lane_common(const ir_type *left, const ir_type *right);
/** `d > 0 ? 1 : 0`: may the operands be converted before one is taken? */
bool lane_is_integer_choice(const lane_scope *l, const ir_node *node);

#endif
