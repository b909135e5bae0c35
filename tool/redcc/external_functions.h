/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Functions of other files of a build, for a report on the whole build. A fact about a function
 * holds only if the program is linked with that definition. So it is used only if exactly one file
 * of the build defines the name, and never for generating code.
 */
#ifndef EXTERNAL_FUNCTIONS_H
#define EXTERNAL_FUNCTIONS_H

#include "analysis/analysis.h"
#include "analysis/memory/exported.h"
#include "support/buffer.h"
#include "support/map.h"

typedef struct external_function {
    exported_kind kind;
    const char *file;
    unsigned definitions; /* the number of definitions in the build */
} external_function;

typedef struct external_functions {
    map *by_name; /* the function's name -> external_function */
    VECTOR(const char *) names;
} external_functions;

/** Writes facts about a file's functions, one line each, for external_read. */
void external_write(buffer *out, const exported_functions *functions);

/** Adds the facts that external_write wrote about `file`; both texts must outlive the arena. */
void external_read(arena *a, external_functions *all, const char *file, const char *text);

/** The facts about functions with exactly one definition, for analysis_options.external; in the
 *  arena. */
const map *external_known(arena *a, const external_functions *all);

/** Sets `external_calls` of the verdicts whose loops call functions of other files, directly or
 * indirectly. */
void external_note(arena *a, const external_functions *all, const analysis_options *options,
                   const ir_unit *unit, const analysis_result *analysis, loop_verdict *verdicts);

#endif
