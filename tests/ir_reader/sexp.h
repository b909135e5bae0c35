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
    unsigned line, column; /* from 1; column in bytes */
    const char *text;      /* atoms; strings without quotes and escapes */
    unsigned count;        /* lists */
    sexp **items;
};

/** Lists may not be deeper. */
enum { SEXP_DEPTH = 4000 };

/**
 * Reads one expression, of which nothing but blanks may follow. A parenthesis inside an atom
 * belongs to it until it closes: "ptr(array(3,double))" is one atom. On bad text returns NULL and
 * puts "line:column: what was expected" into *message (in the arena).
 */
sexp *sexp_read(arena *a, const char *text, size_t length, const char **message);

/** "line:column: " and what was expected. */
const char *sexp_expected(arena *a, const sexp *at, const char *what);

/** Reads a quoted text; `from` stands on the quote. Returns what follows the closing quote, or NULL
 *  where it is missing before `end` or an escape is unknown. */
const char *sexp_unquote(buffer *out, const char *from, const char *end);

#endif
