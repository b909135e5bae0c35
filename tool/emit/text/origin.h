/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The origin of words in generated text.
 *
 * While a loop is written, its text contains marks: after a name, the declaration it refers to;
 * before a type, that type; before an expression that replaces one of the program, its required
 * type; before a copy of the user's bytes, their offset. A mark is enclosed in the bytes 1 and 2,
 * which C text contains only in strings and comments. When the text is complete, the marks are
 * removed and their positions kept: self_check.h compares the declaration that the compiler finds
 * for each name with the one that is meant.
 */
#ifndef EMIT_TEXT_ORIGIN_H
#define EMIT_TEXT_ORIGIN_H

#include "ir/ir.h"
#include "support/buffer.h"
#include "support/vector.h"

typedef enum origin_kind {
    ORIGIN_NAME,     /* the name of a variable, or of its replacement, or of a function */
    ORIGIN_DECLARED, /* such a name in a declaration, or in text that not every compiler reads */
    ORIGIN_TYPE,     /* a type's spelling */
    ORIGIN_VALUE,    /* no bytes: an expression of that type begins here */
    ORIGIN_COPY      /* the user's bytes */
} origin_kind;

/** Bytes [begin, end) of a generated text. All other bytes are the translator's own. */
typedef struct origin {
    origin_kind kind;
    uint32_t begin, end;
    uint32_t from;            /* ORIGIN_COPY: offset of the bytes in the main file */
    const ir_declared *meant; /* ORIGIN_NAME, ORIGIN_DECLARED; NULL: unknown */
    const ir_type *type;      /* ORIGIN_TYPE, ORIGIN_VALUE */
} origin;

typedef struct origin_list {
    VECTOR(origin) items; /* in the order of the text */
} origin_list;

/** The name, marked. */
const char *origin_variable(arena *a, const ir_variable *variable);
const char *origin_function(arena *a, const ir_function *function);
/** The name, marked as that of a declaration. */
const char *origin_declarator(arena *a, const ir_variable *variable);
const char *origin_function_declarator(arena *a, const ir_function *function);
/** The type's spelling, marked; NULL if it has none. */
const char *origin_type(arena *a, const ir_type *type);
/** Another spelling of the type, marked. */
const char *origin_spelling(arena *a, const ir_type *type, const char *spelling);
/** Returns the expression, marked as one that replaces an expression of type `type`. `expression`
 * is a name or an element, or is in parentheses. */
const char *origin_value(arena *a, const ir_type *type, const char *expression);
/** Appends bytes [begin, end) of `text`, marked as a copy of these bytes of the main file. */
void origin_copy(buffer *out, const char *text, uint32_t begin, uint32_t end);

/** The same, for `length` bytes that are a part of the main file, or of a copy, from offset `from`
 * on. */
void origin_copy_bytes(buffer *out, const char *bytes, uint32_t from, uint32_t length);

/** Returns the text without marks, in the arena. The marks' contents are added to *origins (NULL:
 *  they are not needed). If `has_crlf`, each LF without a preceding CR gets one. */
const char *origin_unmark(arena *a, const char *marked, size_t length, bool has_crlf,
                          origin_list *origins);
/** The position after the mark or copy that begins at `at`; `at` itself if none begins there. */
const char *origin_skip(const char *at, const char *end);
/** Does a copy begin at `at`? */
bool origin_is_copy(const char *at, const char *end);
/** The first of the copied bytes, if a copy begins at `at`, otherwise NULL. Sets *from to their
 * offset in the file. */
const char *origin_copied(const char *at, const char *end, uint32_t *from);

#endif
