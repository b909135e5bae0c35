/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Summarises a file's functions for other files, each by one exported_kind. */
#ifndef ANALYSIS_EXPORTED_H
#define ANALYSIS_EXPORTED_H

#include "analysis/base/facts.h"

/** "const", "pure of its arguments" or "pure"; NULL for EXPORTED_NOTHING. */
const char *exported_word(exported_kind kind);

/** May other files of the program adopt this definition? It must have external linkage and no
 *  property that callers in other files cannot see, and its text must determine the compiled
 *  code. */
bool exported_is_plain(arena *a, const ir_unit *unit, const ir_function *function);

typedef struct exported_function {
    const char *name;
    exported_kind kind;
} exported_function;

typedef struct exported_functions {
    unsigned count;
    const exported_function *items; /* every function with external linkage that the file
                                     * defines, except weak ones */
} exported_functions;

/** The exported functions of the unit. All results are allocated in the arena. */
exported_functions exported_of_unit(arena *a, const ir_unit *unit, const analysis_options *options);

#endif
