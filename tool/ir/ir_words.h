/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The names of types, operators and kinds of nodes, in the IR's text form (ir_text.h) and in C. */
#ifndef IR_IR_WORDS_H
#define IR_IR_WORDS_H

#include "ir/ir.h"

/* ---- scalar types -------------------------------------------------------------------------- */

typedef struct ir_scalar {
    const char *word;     /* word in the text form: "ulong" */
    const char *spelling; /* spelling in C: "unsigned long" */
    ir_type_kind kind;
    bool is_signed, is_character;
    int64_t size; /* in bytes, for LP64 (64-bit long and pointers) */
} ir_scalar;

extern const ir_scalar ir_scalars[];
extern const unsigned ir_scalar_count;

const ir_scalar *ir_scalar_named(const char *word, size_t length);
/** Returns the scalar type with the same spelling as `type`, if kind and signedness agree too.
 *  Otherwise returns the first scalar of the same kind and signedness, preferably also of the same
 *  size; NULL if there is none. */
const ir_scalar *ir_scalar_of(const ir_type *type);
/** The type's name in C, such as "unsigned long"; NULL if it matches no scalar. */
const char *ir_scalar_spelling(const ir_type *type);
/** Sets *type to the unqualified scalar type, with its spelling. */
void ir_scalar_type(ir_type *type, const ir_scalar *scalar);

/** The size in bytes under LP64 that kind, target, count and record imply; -1 if unknown. */
int64_t ir_type_default_size(const ir_type *type);

/* ---- operators ----------------------------------------------------------------------------- */

/** The operator as C spells it: "+", "<<", "++". An assignment operator has no "=". */
const char *ir_operator_spelling(ir_operator op);

/* ---- nodes --------------------------------------------------------------------------------- */

enum { IR_ANY_NUMBER = 1000000 };

/** A node kind's word in the text form, and how many children ir.h allows. */
typedef struct ir_kind_word {
    const char *word; /* NULL if the operator is the word */
    unsigned min_children, max_children;
} ir_kind_word;

const ir_kind_word *ir_kind_words(ir_kind kind);

/** Writes the first word of a node's list to `word`: "for", "arrow", "+", "+=", "_++". Returns
 *  false if there is none. */
bool ir_node_word(const ir_node *node, char word[16]);
/** The inverse of ir_node_word. The number of children distinguishes unary and binary operators.
 *  Sets kind, op and IR_ARROW. Returns false for an unknown word. */
bool ir_word_node(const char *word, unsigned child_count, ir_node *node);

/** Is child `index` of a node of this kind a statement? Then the text form may omit the
 *  IR_EXPRESSION around an expression. */
bool ir_is_statement_place(ir_kind kind, unsigned index);

/** The word for the storage in the text form: "global", "static-local". */
const char *ir_storage_word(ir_storage storage);

/* ---- types of expressions that the text may leave out -------------------------------------- */

/** The type that C's rules give the expression from its children, variable, field or text; NULL if
 *  it cannot be inferred. The text form omits a type that equals the inferred one. */
const ir_type *ir_infer_type(arena *a, const ir_node *node);
/** The type of a function with this result. Its spelling lists the types of the function's
 *  parameters. */
const ir_type *ir_function_default_type(arena *a, const ir_function *function,
                                        const ir_type *result);
/** Are the types equal in every respect that the text form shows, including qualifiers, sizes and
 *  spellings? */
bool ir_type_identical(const ir_type *a, const ir_type *b);

/** Stores the value of an integer literal. Returns false if the text is no integer literal, or the
 *  value does not fit. */
bool ir_literal_value(const char *text, int64_t *value);

#endif
