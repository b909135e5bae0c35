/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Functions of other files of a build, for a report on all of it. What is said of a function holds
 * only if the program is linked with that very definition: so it is used where exactly one file of
 * the build defines the name, and never to write code.
 */
#ifndef FOREIGN_H
#define FOREIGN_H

#include "analysis/analysis.h"
#include "analysis/memory/exported.h"
#include "support/buffer.h"
#include "support/map.h"

typedef struct foreign_function {
    exported_kind kind;
    const char *file;
    unsigned definitions; /* how many there are in the build */
} foreign_function;

typedef struct foreign_functions {
    map *by_name; /* -> foreign_function */
    VECTOR(const char *) names;
} foreign_functions;

/** Writes what a file's functions are, a line each, for foreign_read. */
void foreign_write(buffer *out, const exported_functions *functions);

/** Adds what foreign_write wrote of `file`; both texts must live as long as the arena. */
void foreign_read(arena *a, foreign_functions *all, const char *file, const char *text);

/** What may be relied on, for analysis_options.external; in the arena. */
const map *foreign_known(arena *a, const foreign_functions *all);

/** Sets `foreign` of the verdicts whose loops call such functions, by themselves or through others.
 */
void foreign_note(arena *a, const foreign_functions *all, const analysis_options *options,
                  const ir_unit *unit, const analysis_result *analysis, loop_verdict *verdicts);

#endif
