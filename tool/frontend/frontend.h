/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Source text to IR, by libclang. No other folder uses libclang. */
#ifndef FRONTEND_FRONTEND_H
#define FRONTEND_FRONTEND_H

#include "ir/ir.h"

typedef struct frontend_diagnostic {
    const char *text; /* "file:line:column: error: ..." */
    bool is_error;
    bool is_placed;  /* it is in the main file, at offset */
    uint32_t offset; /* for text from a macro: of its expansion */
} frontend_diagnostic;

typedef struct frontend_result {
    ir_unit *unit; /* NULL: nothing could be parsed */
    unsigned diagnostic_count;
    const frontend_diagnostic *diagnostics;
    unsigned file_count;
    const char *const *files; /* files read, including the source itself, under the paths by which
                               * they were found */
} frontend_result;

/** Folders that the parser searches for its own headers, and for gcc's if its own do not suffice.
 *  In the arena; NULL if there is none. */
typedef struct frontend_folders {
    const char *own;
    const char *of_gcc;
} frontend_folders;
frontend_folders frontend_header_folders(arena *a);

/**
 * Parses `src` with the given compiler flags (of a gcc or clang command line; flags that libclang
 * must not see are removed here). All results are allocated in the arena. Functions of the main
 * file get bodies. Those of headers do if a converted function uses them; or, in the program's
 * own headers, if they may have loops and may be called. A function in which the
 * compiler reports an error has has_errors set: ill-formed statements vanish from libclang's tree,
 * so nothing in it may be analysed.
 */
frontend_result frontend_parse(arena *a, const source *src, unsigned flag_count,
                               const char *const *flags);

/** Version of the libclang in use, for --version. */
const char *frontend_version(arena *a);

#endif
