/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which of a compiler's flags libclang is told, and what is added to them. */
#ifndef FRONTEND_FLAGS_H
#define FRONTEND_FLAGS_H

#include <stdbool.h>

#include "support/arena.h"
#include "support/map.h"
#include "support/vector.h"

typedef struct parse_flags {
    VECTOR(const char *) items;
    bool strict_aliasing; /* no -fno-strict-aliasing */
    bool has_headers;     /* no -nostdinc */
    map *predefined;      /* names of a compiler's own macros that the parser is told; NULL: it has
                             its own */
    const char *unseen;   /* a list of macros that cannot be read; NULL: none */
    const char *refusing; /* by it the program is another than the parser's; NULL: none */
    const char *inexact; /* by it floating-point bits depend on what else is compiled; NULL: none */
    bool is_c89;         /* by -std= or -ansi */
    bool is_c23;         /* by -std=, or a later one */
    VECTOR(const char *)
    system_folders;    /* by -isystem and the like: a library's, not the compiler's */
    bool is_sanitized; /* by -fsanitize= of others than addresses, leaks and threads */
    bool is_shared;    /* -fPIC: what is exported may be replaced by another definition ... */
    bool is_fixed;     /* ... but not by one that does something else */
    bool math_errno;   /* mathematical functions set errno */
    bool has_openmp;   /* OpenMP's directives are on */
} parse_flags;

parse_flags choose_flags(arena *a, unsigned count, const char *const *flags);

/** Flags of the -m kind but -m32, -m64 and -mx32: libclang may know fewer of them than the user's
 *  compiler and then parses nothing. */
void remove_machine_flags(parse_flags *flags);

/** gcc's own headers, for what clang's do not have (omp.h). They come last, and only where a header
 *  was missing: clang's stdatomic.h, say, passes on to a second one where there is one, and clang
 *  cannot read gcc's. Returns false where there are none to add. */
bool add_gcc_headers(arena *a, parse_flags *flags);

#endif
