/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Small pieces of C text: strings, operands, declarations; lines with indentation. */
#ifndef EMIT_TEXT_TEXT_H
#define EMIT_TEXT_TEXT_H

#include "ir/ir_c.h"

/** The greatest length of a generated line, unless it is the user's own. */
enum { MOST_COLUMNS = 100 };

/** Lines of generated C. */
typedef struct writer {
    buffer out; /* owned: end with writer_text or buffer_free */
    unsigned depth;
    bool on_one_line; /* blanks instead of line ends and indentation */
} writer;             /* {0} is an empty one */

/** Appends the indentation, the formatted text and a line end. Lines of more than 100 columns are
 * broken, unless they are directives or contain the user's bytes. */
void writer_line(writer *w, const char *format, ...) __attribute__((format(printf, 2, 3)));
/** The text, in the arena; the writer is empty again. */
const char *writer_text(arena *a, writer *w);

/** The text between double quotes, escaped so that it is one C string literal (also in #line). */
const char *text_quoted(arena *a, const char *text);
/** The expression as C, or NULL if it cannot be spelled. */
const char *text_expression(arena *a, const ir_node *expression, ir_c_rename rename, void *context);
/** Like text_expression, but in parentheses unless a cast or & before the text applies to all of
 * it. */
const char *text_operand(arena *a, const ir_node *expression, ir_c_rename rename, void *context);
/** Returns the expression; in parentheses if it contains a comma, at which a macro might split
 *  it. */
const char *macro_argument(arena *a, const char *marked);
/** `type name` without initialiser or `;`; NULL if the type cannot be spelled. */
const char *text_declaration(arena *a, const ir_type *type, const char *name);

#endif
