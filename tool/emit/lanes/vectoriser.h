/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Several iterations at once (redcc/lanes.h): the body of a loop, and the functions that it calls,
 * written once more for vectors.
 */
#ifndef EMIT_LANES_VECTORISER_H
#define EMIT_LANES_VECTORISER_H

#include "emit/base/loop.h"
#include "plan/lanes.h"
#include "support/vector.h"

/** A function written for vectors, with parameters of these classes. */
typedef struct lane_clone {
    const ir_function *function;
    const lane_class *classes; /* [parameter_count] */
    bool is_masked;            /* its first parameter is the mask of the lanes that call it */
    const char *name;
} lane_clone;

typedef VECTOR(lane_clone) lane_clone_list;

typedef struct vectoriser {
    lane_scope in; /* what is being written */
    loop_text *loop;
    lane_clone_list *clones;
    writer *front; /* functions that must stand in front */
    writer *out;
    unsigned depth;        /* of calls */
    bool *is_kept;         /* by variable: in some lanes it keeps what it held */
    const char *mask;      /* of the lanes that do what is being written; NULL: all do */
    const ir_node *region; /* below whose condition it stands; NULL: the others have done all */
    bool may_be_none;      /* perhaps there is no such lane */
    unsigned *mask_count;
} vectoriser;

/** An expression of doubles or of floats: its text, a primary expression; a vector, or a scalar
 * that is the same for all lanes. */
typedef struct lane_value {
    const char *text;
    bool is_vector;
} lane_value;

/** What is called one way for doubles and another way for floats. */
typedef struct lane_words {
    const char *vector; /* the type of their vectors */
    const char *gather; /* makes one of a lane's text */
    const char *same;   /* makes one of a scalar */
    const char *select; /* of two, by a mask */
    const char *mask;   /* makes one of a comparison */
    const char *of;     /* makes one of a vector of the others */
    const char *scalar; /* the type of one */
} lane_words;

/** Those of a type that lane_is_real. */
const lane_words *lane_words_of(const ir_type *type);
/** The expression's value, computed in its own type, in that of `to`, as C converts it. */
lane_value lane_convert(vectoriser *l, lane_value value, const ir_type *from, const ir_type *to);
/** The value as a vector, also where all lanes are the same. */
const char *lane_spread(vectoriser *l, lane_value value, const ir_type *type);

/** The expression for all lanes, converted to a type that lane_is_real. */
lane_value lane_expression(vectoriser *l, const ir_node *node, const ir_type *to);
/** The same as a vector, also where all lanes are the same. */
const char *lane_vector(vectoriser *l, const ir_node *node, const ir_type *to);
/** The text of lane redcc__l; of a uniform expression its own. */
const char *lane_scalar(vectoriser *l, const ir_node *node);
/** The text of a uniform condition, without parentheses around it. */
const char *lane_condition(vectoriser *l, const ir_node *node);
/** A rename of ir_c.h with a vectoriser as its context: things of lane redcc__l. */
const char *lane_rename(const ir_node *node, void *context);
/** The call of a function written for vectors. */
const char *lane_call(vectoriser *l, const ir_node *call);

/** Which lanes a condition holds for. */
const char *lane_mask(vectoriser *l, const ir_node *node);
/** Writes a variable for the lanes of l->mask of which the condition holds as well; its name. */
const char *lane_new_mask(vectoriser *l, const char *condition);
/** The text of one lane's value; 0 in lanes that do not evaluate it, where it may not be. */
const char *lane_guarded(vectoriser *l, const ir_node *node, const char *text);
/** Do lanes that do not execute an assignment to the variable need its old value? */
bool lane_needs_select(const vectoriser *l, const ir_variable *variable);
/** Writes an `if` whose condition is not the same for all lanes. */
void lane_masked_if(vectoriser *l, const ir_node *node);

/** The declaration of a variable of the iteration, without a value. */
void lane_declare(vectoriser *l, const ir_variable *variable);
/** The type without qualifiers of its own. */
const char *lane_type(vectoriser *l, const ir_type *type);
/** Writes what stands in a block that is open, and closes it. */
void lane_part(vectoriser *l, const ir_node *part);
/** Writes what the statement computes, for all lanes. */
void lane_statement(vectoriser *l, const ir_node *statement);

/** Writes a `for` in a block, which begins with what the `for` declares. */
void lane_for(vectoriser *l, const ir_node *loop);

#endif
