/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Counts the loops of a build that redcc-cc would transform, by running redcc-cc itself. */
#ifndef BUILD_COUNTS_H
#define BUILD_COUNTS_H

#include "analysis/base/reason.h"
#include "redcc/options.h"

/** The number of files that are compiled unchanged for the same reason. */
typedef struct left_alone {
    const char *why;
    unsigned files;
} left_alone;

typedef struct build_counts {
    unsigned files; /**< all that redcc-cc reports on; a file compiled twice counts twice */
    VECTOR(left_alone) left;                     /**< by reason, in order of appearance */
    unsigned transformed, refused[REASON_COUNT]; /**< loops */
} build_counts;

/** Runs the redcc-cc of this installation with --redcc-report on each command of
 *  FOLDER/compile_commands.json that compiles a C file. Passes on the compiler's flags of `o` and
 * its options for loops or, if there are none, $REDCC_OPTS. Returns false if there is no redcc-cc,
 * the commands cannot be read, or processes cannot be started: *counts is then incomplete. */
bool build_counts_take(arena *a, const options *o, build_counts *counts);

#endif
