/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Where the written text forbids to contract a multiplication and an addition into one rounding.
 */
#ifndef EMIT_CONTRACT_H
#define EMIT_CONTRACT_H

#include "emit/emit.h"

typedef enum contraction {
    CONTRACTION_ALLOWED,
    CONTRACTION_OFF_IN_LOOPS, /* and in the functions around them, where compilers need that */
    CONTRACTION_OFF_IN_FILE
} contraction;

/** Of all loops that are to be transformed. is_forbidden: [verdicts] becomes true where it is
 * forbidden in the loop itself: something in it, or in what it calls, could be contracted, perhaps
 * with what stands outside. */
contraction contraction_of(arena *a, const ir_unit *unit, const analysis_result *analysis,
                           const emit_options *options, bool *is_forbidden);

/** The directives that turn it off from the head of the file on. has_targets: functions are
 * compiled for several processors. */
const char *contraction_directives(arena *a, const ir_unit *unit, bool has_targets);

/** What goes in front of a function with loops: text, and its place. */
const char *unfused_function(arena *a, const ir_unit *unit, const ir_function *function,
                             uint32_t *place);

#endif
