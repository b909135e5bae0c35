/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Selects the compiler's flags that are passed to libclang, and those added to them. */
#ifndef FRONTEND_FLAGS_H
#define FRONTEND_FLAGS_H

#include <stdbool.h>

#include "support/arena.h"
#include "support/map.h"
#include "support/vector.h"

typedef struct parse_flags {
    VECTOR(const char *) items;
    bool strict_aliasing; /* no -fno-strict-aliasing */
    bool has_headers;     /* the standard headers are found: no -nostdinc */
    map *predefined; /* the compiler's predefined macros, if they replace the parser's; else NULL */
    const char *unseen;   /* a file of predefined macros that cannot be read; NULL: none */
    const char *refusing; /* an option that makes the program differ from the parsed one; NULL:
                           * none */
    const char *inexact;  /* an option by which floating-point bits depend on other code in the
                           * compilation; NULL: none */
    bool is_c89;          /* by -std= or -ansi */
    bool is_c23;          /* by -std=, or a later one */
    VECTOR(const char *)
    system_folders;         /* of libraries, by -isystem and the like; not the compiler's */
    bool is_sanitized;      /* by -fsanitize=: undefined arithmetic may end the program */
    bool may_be_interposed; /* -fPIC: another definition may replace an exported one */
    bool no_interposition;  /* -fno-semantic-interposition: only by an equivalent one */
    bool math_errno;        /* mathematical functions set errno */
    bool wraps;             /* -fwrapv */
    bool has_openmp;        /* OpenMP's directives are on */
} parse_flags;

/** The path with the highest version number in it (gcc/12 is newer than gcc/9), as strverscmp(3)
 *  compares; NULL if there are none. */
const char *newest_folder(size_t count, char *const *paths);

parse_flags choose_flags(arena *a, unsigned count, const char *const *flags);

/** Removes flags of the -m kind except -m32, -m64 and -mx32: libclang may know fewer of them than
 *  the user's compiler, and then parses nothing. */
void remove_machine_flags(parse_flags *flags);

/** gcc's own headers, for those that clang lacks (omp.h). They are added last, and only after
 *  a header was not found: clang's own headers may include gcc's of the same name, such as
 *  stdatomic.h, which clang cannot read. Returns false if there are none to add. */
bool add_gcc_headers(arena *a, parse_flags *flags);

#endif
