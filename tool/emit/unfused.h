/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The text that turns contraction off (fusing a multiplication and an addition): directives, and
 * function attributes. */
#ifndef EMIT_UNFUSED_H
#define EMIT_UNFUSED_H

#include "emit/base/loop.h"

/** The directives that turn contraction off for the whole file. `has_targets`: some functions are
 * compiled for several processors. */
const char *contraction_directives(arena *a, const ir_unit *unit, bool has_targets);

/** The text before a function that turns contraction off in it; sets *place to its position. */
const char *unfused_function(arena *a, const ir_unit *unit, const ir_function *function,
                             uint32_t *place);

#endif
