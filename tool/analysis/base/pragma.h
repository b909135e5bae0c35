/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * #pragma redcc: the user's assertions about a loop or a function. docs/pragmas.md explains each.
 *   private(NAME, ...)   above a loop: each iteration writes these before it reads them
 *   independent          above a loop: distinct pointers in it do not overlap
 *   ignore               above a loop: it and the loops in it stay as they are
 *   pure(NAME, ...)      anywhere: these functions have no side effects, as by --pure
 */
#ifndef ANALYSIS_PRAGMA_H
#define ANALYSIS_PRAGMA_H

#include "ir/ir.h"
#include "support/vector.h"

typedef enum pragma_word {
    PRAGMA_OTHER, /* not of redcc */
    PRAGMA_PRIVATE,
    PRAGMA_INDEPENDENT,
    PRAGMA_IGNORE,
    PRAGMA_PURE
} pragma_word;

typedef struct user_pragma {
    pragma_word word;
    ir_range range;   /* of the directive */
    const char *text; /* as in reports: "private(f, g)" */
    unsigned name_count;
    const char *const *names;
    const ir_node *loop; /* the loop directly after it; NULL: none */
} user_pragma;

typedef struct pragma_problem {
    uint32_t offset; /* in the file */
    const char *message;
} pragma_problem;

typedef struct user_pragmas {
    unsigned count;
    const user_pragma *items; /* in source order, without those in branches not compiled */
    unsigned problem_count;
    const pragma_problem *problems;
} user_pragmas;

/**
 * Parses one directive's text, which may contain splices and comments. Returns NULL, with *result
 * filled in except for range and loop, or a message, with its offset in *offset. Allocated in the
 * arena.
 */
const char *pragma_parse(arena *a, const char *text, user_pragma *result, uint32_t *offset);

/** All pragmas of the unit; those without a loop after them, or with unknown names, are
 *  problems. */
user_pragmas pragmas_of_unit(arena *a, const ir_unit *unit);

/** The pragma of this kind above this loop, or NULL. */
const user_pragma *pragma_above(const user_pragmas *all, const ir_node *loop, pragma_word word);
bool pragma_names(const user_pragma *pragma, const char *name);

#endif
