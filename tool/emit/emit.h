/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Writes the output: the user's file, in which a block replaces each transformed loop. The block
 * contains the parallel and the original form. docs/generated-code.md shows a complete example.
 */
#ifndef EMIT_EMIT_H
#define EMIT_EMIT_H

#include "analysis/analysis.h"
#include "emit/text/origin.h"
#include "plan/lane_reason.h"
#include "plan/options.h"

/** The first lines of each written file. */
#define REDCC_BEGINNING                                                                            \
    "#if !defined(REDCC_OFF) && defined(__has_include)\n"                                          \
    "#if __has_include(<redcc/runtime.h>)\n"                                                       \
    "#include <redcc/runtime.h>\n"
/** The beginning of the line after REDCC_BEGINNING. */
#define REDCC_REQUIREMENT "REDCC_REQUIRE_VERSION("

/** A piece of a loop's generated text. It replaces the loop or a part of it, or is inserted before
 * or into the loop's function. */
typedef struct written_loop {
    unsigned verdict;    /* index of the loop's verdict */
    bool has_lanes;      /* the loop has the optional form for several iterations at once */
    ir_range replaced;   /* bytes of the input */
    uint32_t begin, end; /* bytes of the result that replace them */
    const char *text;    /* bytes [begin, end) of the result */
    ir_range copied;     /* if the piece precedes a function: the range of the user's body */
    origin_list origins; /* origins of its words (origin.h); offsets are relative to `begin` */
} written_loop;

typedef struct emit_result {
    const char *text; /* `length` bytes and a 0; the input's own bytes if loop_count is 0 */
    size_t length;
    unsigned loop_count;       /* number of pieces of all written loops */
    const written_loop *loops; /* the pieces, in the order of their positions */
    /* For each verdict, the reason why the loop cannot be written. Message and range are set; the
     * id is not. Such a loop is left unchanged. The message is NULL if the loop can be written. */
    const reason *obstacles;
    /* For each verdict, whether a form for several iterations at once was written, or why not.
     * LANES_NOT_ASKED: no such form was requested. NULL if no verdict's loop is to be written. */
    const lanes_outcome *lanes;
    /* For each verdict, why updates that OpenMP leaves unordered keep the order of the loop; NULL
     * if there are none, or they do not. NULL as a whole if no verdict's loop is to be written. */
    const char *const *in_order;
} emit_result;

/** Writes all loops whose verdict is VERDICT_TRANSFORM or VERDICT_BLOCKS. All results are allocated
 * in the arena, or belong to the source. */
emit_result emit_file(arena *a, const ir_unit *unit, const analysis_result *analysis,
                      const plan_options *options);

#endif
