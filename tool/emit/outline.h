/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Slice and body as functions before the user's function. */
#ifndef EMIT_OUTLINE_H
#define EMIT_OUTLINE_H

#include "emit/base/loop.h"

/** Slice, body and the function that each thread calls, to be inserted at *place. NULL: they cannot
 *  be written (loop->obstacle). */
const char *write_outlined(loop_text *loop, uint32_t *place);

#endif
