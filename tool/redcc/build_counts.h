/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What a build by redcc-cc makes of its loops, counted by redcc-cc itself. */
#ifndef BUILD_COUNTS_H
#define BUILD_COUNTS_H

#include "analysis/base/reason.h"
#include "redcc/options.h"

/** Files that are compiled as they are, for one reason. */
typedef struct left_alone {
    const char *why;
    unsigned files;
} left_alone;

typedef struct build_counts {
    unsigned files; /**< translated, or looked at and left as they are; one that is compiled twice
                         counts twice */
    VECTOR(left_alone) left;                     /**< by reason, in order of appearance */
    unsigned transformed, refused[REASON_COUNT]; /**< loops */
} build_counts;

/** Lets the redcc-cc beside this program report (--redcc-report) on each command of
 *  FOLDER/compile_commands.json that compiles a C file, with the options `o` gives on loops and the
 *  compiler's flags; where it gives none, with $REDCC_OPTS. Returns false where there is no
 *  redcc-cc, or processes cannot be started: then *counts holds nothing. */
bool build_counts_take(arena *a, const options *o, build_counts *counts);

#endif
