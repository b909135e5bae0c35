/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Source text to IR, by libclang. The only room that knows libclang. */
#ifndef FRONTEND_FRONTEND_H
#define FRONTEND_FRONTEND_H

#include "ir/ir.h"

typedef struct frontend_diagnostic {
    const char *text; /* "file:line:column: error: ..." */
    bool is_error;
    bool is_placed;  /* it lies in the main file, */
    uint32_t offset; /* here: where the macro is expanded that makes it */
} frontend_diagnostic;

typedef struct frontend_result {
    ir_unit *unit; /* NULL: nothing could be parsed at all */
    unsigned diagnostic_count;
    const frontend_diagnostic *diagnostics;
    unsigned file_count;
    const char *const *files; /* that were read, the source itself among them, as they were found */
} frontend_result;

/** Folders in which the parser looks for its own headers, and for gcc's where its own do not do. In
 *  the arena; NULL where there is none. */
typedef struct frontend_folders {
    const char *own;
    const char *of_gcc;
} frontend_folders;
frontend_folders frontend_header_folders(arena *a);

/**
 * Parses `src` with the compiler flags given (a gcc or clang command line's; what libclang must
 * not see is left out here). Everything returned lives in the arena.
 * Functions of the main file get bodies, of headers only where called from the main file. A
 * function in which the compiler reports an error has has_errors set: ill-formed statements vanish
 * from libclang's tree, so nothing in it may be analysed.
 */
frontend_result frontend_parse(arena *a, const source *src, unsigned flag_count,
                               const char *const *flags);

/** Version of the libclang in use, for --version. */
const char *frontend_version(arena *a);

#endif
