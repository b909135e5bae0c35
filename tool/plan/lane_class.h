/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Classes of an iteration's variables when several iterations are executed at once. The class of an
 * expression follows from those of its variables. All lanes execute the same iterations of inner
 * loops; an `if` may concern some lanes only. Updates are executed lane by lane.
 *
 * An integer or pointer is uniform if all values assigned to it are uniform, and all lanes execute
 * all its assignments. Update statements may assign it only as a loop's counter. Classes are
 * propagated over assignments to a fixed point.
 */
#ifndef PLAN_LANE_CLASS_H
#define PLAN_LANE_CLASS_H

#include "plan/lane_reason.h"
#include "plan/plan.h"

typedef enum lane_class {
    LANE_UNIFORM, /* the same in all lanes: a scalar */
    LANE_VARYING, /* an integer or pointer per lane: an array of them */
    LANE_MASK,    /* a const integer initialised by comparisons of doubles or floats: a vector of -1
                   * (true) or 0 */
    LANE_LOCAL,   /* declared in an update statement: private to each lane's updates */
    LANE_VECTOR   /* a double or float, or an array of them, per lane: vectors */
} lane_class;

/** The code that gets a vector form: the loop's body, or a function that it calls. */
typedef struct lane_scope {
    const loop_plan *plan;
    const ir_function *function; /* NULL: the loop's body */
    const ir_node *body;
    lane_class *class_of; /* indexed by variable */
    ir_range place;       /* the range of the last statement that the file itself contains */
    lanes_outcome *outcome;
} lane_scope;

/** Records the reason why the scope has no vector form, unless a reason is recorded already. The
 *  message points at `node` or, if it is NULL, at the last recorded place. */
void lane_problem(const lane_scope *l, lane_reason why, const ir_node *node);
/** Records the place of the current statement. */
void lane_note_place(lane_scope *l, const ir_node *node);

/** Gives each variable of the scope its class, except for parameters of a function, whose classes
 *  are set by the call (lane_parameter_class). */
void lane_classify(lane_scope *l);

/** Is the variable private to the iteration, or declared in the function being written? */
bool lane_is_own(const lane_scope *l, const ir_variable *variable);
bool lane_is_uniform(const lane_scope *l, const ir_node *node);
/** Does the expression contain no call, assignment, increment, string or initialiser list? */
bool lane_is_plain(const ir_node *node);
/** Is a LANE_VECTOR variable used other than through one of its elements? */
bool lane_has_whole_vector(const lane_scope *l, const ir_node *node);
bool lane_mentions_vector(const lane_scope *l, const ir_node *node);
/** The LANE_VECTOR variable that the node names as a whole or by an element with uniform
 * subscripts, or NULL if there is none. */
const ir_variable *lane_vector_root(const lane_scope *l, const ir_node *node);
/** Like lane_vector_root, but subscripts may differ between lanes. */
const ir_variable *lane_vector_element(const lane_scope *l, const ir_node *node);
/** Is the type double or float? Only these have vectors. */
bool lane_is_real(const ir_type *type);
/** Is it safe to evaluate the expression where the program does not? */
bool lane_is_safe(const lane_scope *l, const ir_node *node);
/** Do vectors have the operator: + - * or /? */
bool lane_has_operator(ir_operator op);
/** The reason why an operand that is not plain is rejected. */
lane_reason lane_effect_of(const ir_node *node);
/** The type of an operator's result: double if an operand is double, otherwise float. Returns NULL
 * if neither operand is a double or float, or one is neither that nor an integer. */
const ir_type *lane_common(const ir_type *left, const ir_type *right);
/** In a conditional expression such as `d > 0 ? 1 : 0`: may the operands be converted before the
 * selection? Not if C first converts one to another integer type. */
bool lane_is_integer_choice(const lane_scope *l, const ir_node *node);

#endif
