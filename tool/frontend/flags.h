/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Selects which of the compiler's flags are passed to libclang, and adds further ones. */
#ifndef FRONTEND_FLAGS_H
#define FRONTEND_FLAGS_H

#include <stdbool.h>

#include "support/arena.h"
#include "support/map.h"
#include "support/vector.h"

typedef struct parse_flags {
    VECTOR(const char *) items;
    bool strict_aliasing; /* false if -fno-strict-aliasing is the last such option */
    bool has_headers;     /* the standard headers can be found (no -nostdinc) */
    map *predefined;      /* the compiler's predefined macros, if they replace libclang's; otherwise
                           * NULL */
    const char *unseen;   /* a file of predefined macros that cannot be read; NULL if there is
                           * none */
    const char *refusing; /* an option that makes the compiled program differ from the parsed one;
                           * NULL if there is none */
    const char *inexact;  /* an option that lets floating-point bits depend on other code in the
                           * compilation; NULL if there is none */
    bool is_c89;          /* -std= names C89 or C90, or -ansi is given */
    bool is_c23;          /* -std= names C23 or a later standard */
    VECTOR(const char *)
    system_folders;         /* folders of libraries, given by -isystem and the like; not the
                             * compiler's own */
    bool is_sanitized;      /* -fsanitize= names a sanitizer by which undefined arithmetic may end
                             * the program */
    bool may_be_interposed; /* -fPIC: another definition may replace an exported one at run
                             * time */
    bool no_interposition;  /* -fno-semantic-interposition: only an equivalent definition may
                             * replace it */
    bool math_errno;        /* mathematical functions may set errno */
    bool wraps;             /* -fwrapv: signed overflow wraps around */
    bool has_openmp;        /* OpenMP directives are enabled */
} parse_flags;

/** The path with the highest version number, compared as by strverscmp(3): gcc/12 is newer than
 *  gcc/9. NULL if `count` is 0. */
const char *newest_folder(size_t count, char *const *paths);

parse_flags choose_flags(arena *a, unsigned count, const char *const *flags);

/** Removes all flags that begin with -m, except -m32, -m64 and -mx32. libclang may not know a
 *  machine flag of the user's compiler, and then parses nothing. */
void remove_machine_flags(parse_flags *flags);

/** Adds the folder of gcc's own headers, for headers that clang lacks (omp.h). Call it only after a
 *  header was not found. The folder is searched last, because clang cannot read some of gcc's
 *  headers that also exist in clang's folder, such as stdatomic.h. Returns false if there is no
 *  such folder. */
bool add_gcc_headers(arena *a, parse_flags *flags);

#endif
