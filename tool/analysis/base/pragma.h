/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** #pragma redcc states facts that the user guarantees, about a loop or about functions. Only
 *  `ignore` is a request. docs/pragmas.md explains each.
 *    private(NAME, ...) above a loop: each iteration writes these before it reads them
 *    independent above a loop: distinct pointers in it do not overlap
 *    ignore above a loop: it and the loops in it stay as they are
 *    pure(NAME, ...) anywhere: these functions have no side effects, like --pure */
#ifndef ANALYSIS_PRAGMA_H
#define ANALYSIS_PRAGMA_H

#include "ir/ir.h"
#include "support/vector.h"

typedef enum pragma_word {
    PRAGMA_OTHER, /* not a pragma of redcc */
    PRAGMA_PRIVATE,
    PRAGMA_INDEPENDENT,
    PRAGMA_IGNORE,
    PRAGMA_PURE
} pragma_word;

typedef struct user_pragma {
    pragma_word word;
    ir_range range;   /* range of the directive */
    const char *text; /* the text for reports, such as "private(f, g)" */
    unsigned name_count;
    const char *const *names;
    const ir_node *loop; /* the loop directly after it; NULL if there is none */
} user_pragma;

typedef struct pragma_problem {
    uint32_t offset; /* in the main file */
    const char *message;
} pragma_problem;

typedef struct user_pragmas {
    unsigned count;
    const user_pragma *items; /* in source order; those in branches that are not compiled are left
                               * out */
    unsigned problem_count;
    const pragma_problem *problems;
} user_pragmas;

/** Parses one directive's text, which may contain splices and comments. Returns NULL on success;
 *  *result then has all fields except range and loop, and its word is PRAGMA_OTHER if the pragma is
 *  not redcc's. Otherwise returns an error message and stores its position in *offset. Allocates in
 *  the arena. */
const char *pragma_parse(arena *a, const char *text, user_pragma *result, uint32_t *offset);

/** All pragmas of the unit. A pragma is reported as a problem if it needs a loop and has none after
 *  it, or if the loop does not use a variable that it names. */
user_pragmas pragmas_of_unit(arena *a, const ir_unit *unit);

/** The pragma of this kind directly above this loop; NULL if there is none. */
const user_pragma *pragma_above(const user_pragmas *all, const ir_node *loop, pragma_word word);
bool pragma_names(const user_pragma *pragma, const char *name);

#endif
