/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** S-expressions: lists of atoms, quoted strings and lists. `;` begins a comment. */
#ifndef IR_SEXP_H
#define IR_SEXP_H

#include <stdbool.h>
#include <stddef.h>

#include "support/arena.h"
#include "support/buffer.h"

typedef enum sexp_kind { SEXP_ATOM, SEXP_STRING, SEXP_LIST } sexp_kind;

typedef struct sexp sexp;
struct sexp {
    sexp_kind kind;
    unsigned line, column; /* line and column from 1; the column counts bytes */
    const char *text;      /* an atom's text, or a string's contents after escapes */
    unsigned count;        /* number of a list's items */
    sexp **items;
};

/** The greatest permitted depth of lists. */
enum { SEXP_DEPTH = 4000 };

/**
 * Reads one expression, after which only blanks may follow. A parenthesis inside an atom is part of
 * the atom, up to its closing parenthesis: "ptr(array(3,double))" is one atom. If the text is
 * invalid, returns NULL and sets *message to "line:column: what was expected" (in the arena).
 */
sexp *sexp_read(arena *a, const char *text, size_t length, const char **message);

/** Returns "line:column: " and what was expected. */
const char *sexp_expected(arena *a, const sexp *at, const char *what);

/** Reads a quoted text; `from` points to the opening quote. Returns the position after the closing
 * quote, or NULL if there is none before `end` or an escape is unknown. */
const char *sexp_unquote(buffer *out, const char *from, const char *end);

#endif
