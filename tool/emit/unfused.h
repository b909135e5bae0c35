/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The text that turns contraction off: directives, and attributes of functions. */
#ifndef EMIT_UNFUSED_H
#define EMIT_UNFUSED_H

#include "emit/base/loop.h"

/** The directives that turn it off from the head of the file on. has_targets: functions are
 *  compiled for several processors. */
const char *contraction_directives(arena *a, const ir_unit *unit, bool has_targets);

/** The text before a function with loops, and its position. */
const char *unfused_function(arena *a, const ir_unit *unit, const ir_function *function,
                             uint32_t *place);

#endif
