/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Verdicts to output text: the user's file with each loop that is to run in parallel replaced by a
 * block that holds both forms of it. docs/generated-code.md shows one whole.
 */
#ifndef EMIT_EMIT_H
#define EMIT_EMIT_H

#include "analysis/analysis.h"
#include "emit/text/origin.h"
#include "plan/lane_reason.h"
#include "plan/options.h"

/** What each text begins with. */
#define REDCC_BEGINNING                                                                            \
    "#if !defined(REDCC_OFF) && defined(__has_include)\n"                                          \
    "#if __has_include(<redcc/runtime.h>)\n"                                                       \
    "#include <redcc/runtime.h>\n"

/** A loop as it was written, or what of it stands in front of its function. */
typedef struct written_loop {
    unsigned verdict;    /* which */
    bool has_lanes;      /* it may be written without */
    ir_range replaced;   /* bytes of the input */
    uint32_t begin, end; /* bytes of the result that stand for them: */
    const char *text;    /* these */
    ir_range copied;     /* of a piece in front of a function: the user's body */
    origin_list origins; /* where the words of these come from; places count from `begin` */
} written_loop;

typedef struct emit_result {
    const char *text; /* `length` bytes and a 0; the input's own bytes where loop_count is 0 */
    size_t length;
    unsigned loop_count;       /* pieces of loops written in parallel form, */
    const written_loop *loops; /* by their place */
    /* For each verdict: why the text cannot say what was found (a reason without an id, message
     * and range filled in), message NULL where it can. Such a loop is left as it is. */
    const reason *obstacles;
    /* For each verdict: has it a form for several iterations at once? NULL: none was asked for. */
    const lanes_outcome *lanes;
} emit_result;

/** Writes all loops whose verdict is VERDICT_TRANSFORM. Everything returned lives in the arena (or
 *  is the source's). */
emit_result emit_file(arena *a, const ir_unit *unit, const analysis_result *analysis,
                      const plan_options *options);

#endif
