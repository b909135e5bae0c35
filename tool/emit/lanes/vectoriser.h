/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Lanes (redcc/lanes.h): writes the body of a loop, and the functions that it calls, once more with
 * vectors, which compute several iterations at once.
 */
#ifndef EMIT_LANES_VECTORISER_H
#define EMIT_LANES_VECTORISER_H

#include "emit/base/loop.h"
#include "plan/lanes.h"
#include "support/vector.h"

/** The vector form of a function. `classes` says how it gets each parameter. */
typedef struct lane_clone {
    const ir_function *function;
    const lane_class *classes; /* [parameter_count] */
    bool is_masked;            /* the first parameter is the mask of the lanes that call it */
    const char *name;
} lane_clone;

typedef VECTOR(lane_clone) lane_clone_list;

typedef struct vectoriser {
    lane_scope in; /* scope of the code being written */
    loop_text *loop;
    lane_clone_list *clones;
    writer *front; /* vector forms of called functions, inserted before the current function */
    writer *out;
    unsigned depth;        /* nesting depth of calls */
    bool *is_kept;         /* indexed by variable: some lanes keep its old value */
    const char *mask;      /* the lanes that execute the current code; NULL: all */
    const ir_node *region; /* code under the mask's condition, or NULL if inactive lanes have
                            * ended */
    bool may_be_none;      /* the current code may be executed without any active lane */
    unsigned *mask_count;
} vectoriser;

/** The text of a floating expression, as a primary expression: a vector, or a scalar that is the
 * same for all lanes. */
typedef struct lane_value {
    const char *text;
    bool is_vector;
} lane_value;

/** Names that differ between doubles and floats. */
typedef struct lane_words {
    const char *vector; /* the type of their vectors */
    const char *gather; /* makes a vector from an expression for lane redcc__l */
    const char *same;   /* makes a vector from a scalar */
    const char *select; /* selects between two vectors by a mask */
    const char *mask;   /* makes a mask from a comparison */
    const char *of;     /* converts a vector of the other type to this one */
    const char *scalar; /* the type of a single value */
} lane_words;

/** The names for a type that satisfies lane_is_real. */
const lane_words *lane_words_of(const ir_type *type);
/** Converts a value, computed in the type `from`, to `to` as C does. */
lane_value lane_convert(vectoriser *l, lane_value value, const ir_type *from, const ir_type *to);
/** The value as a vector, even if all lanes are the same. */
const char *lane_spread(vectoriser *l, lane_value value, const ir_type *type);

/** The expression for all lanes, converted to a type that satisfies lane_is_real. */
lane_value lane_expression(vectoriser *l, const ir_node *node, const ir_type *to);
/** Like lane_expression, but the result is always a vector. */
const char *lane_vector(vectoriser *l, const ir_node *node, const ir_type *to);
/** The expression for lane redcc__l; the user's own if it is uniform. */
const char *lane_scalar(vectoriser *l, const ir_node *node);
/** The text of a uniform condition, without parentheses around it. */
const char *lane_condition(vectoriser *l, const ir_node *node);
/** An ir_c_rename, with a vectoriser as its context, that gives the names for lane redcc__l. */
const char *lane_rename(const ir_node *node, void *context);
/** The call of a function written for vectors. */
const char *lane_call(vectoriser *l, const ir_node *call);

/** The mask of the lanes for which a condition holds. */
const char *lane_mask(vectoriser *l, const ir_node *node);
/** Writes a variable with the mask of the lanes of l->mask that satisfy the condition; returns its
 *  name. */
const char *lane_new_mask(vectoriser *l, const char *condition);
/** `text`, an expression for one lane; 0 in inactive lanes, if evaluating it there is unsafe. */
const char *lane_masked(vectoriser *l, const ir_node *node, const char *text);
/** Do lanes that do not execute an assignment to the variable need its old value? */
bool lane_needs_select(const vectoriser *l, const ir_variable *variable);
/** Writes an `if` whose condition is not the same for all lanes. */
void lane_masked_if(vectoriser *l, const ir_node *node);

/** Declares a variable of the iteration, without a value. */
void lane_declare(vectoriser *l, const ir_variable *variable);
/** The type without its own qualifiers. */
const char *lane_type(vectoriser *l, const ir_type *type);
/** Writes the contents of a block that is open, and closes it. */
void lane_part(vectoriser *l, const ir_node *part);
/** Writes the computations of the statement, for all lanes. */
void lane_statement(vectoriser *l, const ir_node *statement);

/** Writes a `for` in a block, which begins with the declarations of the `for`. */
void lane_for(vectoriser *l, const ir_node *loop);

#endif
