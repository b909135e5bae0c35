/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What a file tells other files of its functions: the summaries that can be said in a word. */
#ifndef ANALYSIS_EXPORTED_H
#define ANALYSIS_EXPORTED_H

#include "analysis/base/facts.h"

/** "const", "pure of its arguments", "pure"; NULL for EXPORTED_NOTHING. */
const char *exported_word(exported_kind kind);

/**
 * Is this a definition of which the file may speak to others: an external function, as plain as
 * they take it for, whose own text says all that a compiler makes of it?
 */
bool exported_is_plain(arena *a, const ir_unit *unit, const ir_function *function);

typedef struct exported_function {
    const char *name;
    exported_kind kind;
} exported_function;

typedef struct exported_functions {
    unsigned count;
    const exported_function *items; /* every function with external linkage that the file defines */
} exported_functions;

/** Everything returned lives in the arena. */
exported_functions exported_of_unit(arena *a, const ir_unit *unit, const analysis_options *options);

#endif
