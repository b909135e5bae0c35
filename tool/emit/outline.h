/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes slice and body as functions before the user's function. */
#ifndef EMIT_OUTLINE_H
#define EMIT_OUTLINE_H

#include "emit/base/loop.h"

/** Writes slice, body and the function that each thread calls, to be inserted at *place. Returns
 * NULL, with loop->obstacle set, if they cannot be written. */
const char *write_outlined(loop_text *loop, uint32_t *place);

#endif
