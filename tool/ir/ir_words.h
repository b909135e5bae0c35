/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The words of the text form and the spellings of C, shared by printer, reader and checker. */
#ifndef IR_IR_WORDS_H
#define IR_IR_WORDS_H

#include "ir/ir.h"

/* ---- scalar types -------------------------------------------------------------------------- */

typedef struct ir_scalar {
    const char *word;     /* in the text form: "ulong" */
    const char *spelling; /* in C: "unsigned long" */
    ir_type_kind kind;
    bool is_signed, is_character;
    int64_t size; /* LP64 */
} ir_scalar;

extern const ir_scalar ir_scalars[];
extern const unsigned ir_scalar_count;

const ir_scalar *ir_scalar_named(const char *word, size_t length);
/** The scalar with the type's spelling if its structure agrees; else the first with the same
 *  structure, if possible also with its size. NULL if none matches. */
const ir_scalar *ir_scalar_of(const ir_type *type);
/** "unsigned long"; NULL if the type is no scalar known by name. */
const char *ir_scalar_spelling(const ir_type *type);
/** Fills in a type, unqualified, with spelling. */
void ir_scalar_type(ir_type *type, const ir_scalar *scalar);

/** The size that kind, target, count and record imply under LP64; -1 unknown. Scalars: their
 *  size. */
int64_t ir_type_default_size(const ir_type *type);

/* ---- operators ----------------------------------------------------------------------------- */

/** As C spells it: "+", "<<=" without the "=", "++". */
const char *ir_operator_spelling(ir_operator op);

/* ---- nodes --------------------------------------------------------------------------------- */

enum { IR_ANY_NUMBER = 1000000 };

/** The text form's word for a kind, and its number of children by ir.h. */
typedef struct ir_kind_word {
    const char *word; /* NULL: named by its operator */
    unsigned min_children, max_children;
} ir_kind_word;

const ir_kind_word *ir_kind_words(ir_kind kind);

/** The first word of a node's list: "for", "arrow", "+", "+=", "_++". Returns false if no word
 *  fits. `word` has room for 16 bytes. */
bool ir_node_word(const ir_node *node, char word[16]);
/** The inverse of ir_node_word. The number of children distinguishes unary and binary operators.
 *  Sets kind, op and IR_ARROW. Returns false for an unknown word. */
bool ir_word_node(const char *word, unsigned child_count, ir_node *node);

/** Is child number `index` of this kind a statement? Then the text form may leave out IR_EXPRESSION
 *  around an expression. */
bool ir_is_statement_place(ir_kind kind, unsigned index);

/** The storage's word: "global", "static-local". */
const char *ir_storage_word(ir_storage storage);

/* ---- types of expressions that the text may leave out -------------------------------------- */

/** The type that C's rules give the expression from its children, variable, field or text; NULL:
 *  not known. The text form leaves out a type that is the inferred one. */
const ir_type *ir_infer_type(arena *a, const ir_node *node);
/** The type of a function with this result, its spelling made of the parameters' types. */
const ir_type *ir_function_default_type(arena *a, const ir_function *function,
                                        const ir_type *result);
/** Equal in every respect, including qualifiers, sizes and spellings. */
bool ir_type_identical(const ir_type *a, const ir_type *b);

/** The value of an integer literal as the text form and the frontend understand it. Returns false
 *  if the text is no integer literal or does not fit. */
bool ir_literal_value(const char *text, int64_t *value);

#endif
