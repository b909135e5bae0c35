/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Converts source text to IR, using libclang. No other folder uses libclang. */
#ifndef FRONTEND_FRONTEND_H
#define FRONTEND_FRONTEND_H

#include "ir/ir.h"

typedef struct frontend_diagnostic {
    const char *text; /* "file:line:column: error: ..." */
    bool is_error;
    bool is_placed;  /* it is in the main file, at `offset` */
    uint32_t offset; /* for text that a macro produces, the offset of the expansion */
} frontend_diagnostic;

typedef struct frontend_result {
    ir_unit *unit; /* NULL if nothing could be parsed */
    unsigned diagnostic_count;
    const frontend_diagnostic *diagnostics;
    unsigned file_count;
    const char *const *files; /* the files that were read, including the source itself, under the
                               * paths by which they were found */
} frontend_result;

/** The folder in which the parser searches for its own headers, and the folder of gcc's headers,
 *  which the parser searches if a header is in no other folder. The strings are static or in the
 *  arena; NULL if there is no such folder. */
typedef struct frontend_folders {
    const char *own;
    const char *of_gcc;
} frontend_folders;
frontend_folders frontend_header_folders(arena *a);

/** Parses `src` with the flags of a gcc or clang command line; flags that libclang must not get are
 *  removed first. All results are allocated in the arena.
 *
 *  Functions of the main file get bodies. A function of a header gets one if a converted function
 *  uses it. A function of the program's own headers also gets one if it may have a loop and may be
 *  called.
 *
 *  If the compiler reports an error inside a function, its has_errors is set, and nothing in it may
 *  be analysed: ill-formed statements are missing from libclang's tree. */
frontend_result frontend_parse(arena *a, const source *src, unsigned flag_count,
                               const char *const *flags);

/** Parses `src` for its diagnostics alone: the result has no unit. Returns false if nothing could
 * be parsed. */
bool frontend_diagnose(arena *a, const source *src, unsigned flag_count, const char *const *flags,
                       frontend_result *result);

/** The version of libclang, for --version. */
const char *frontend_version(arena *a);

#endif
