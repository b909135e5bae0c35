/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes the header of a loop that may continue at an iteration that leaves it
 *  (plan/continuation.h). */
#ifndef EMIT_CONTINUATION_H
#define EMIT_CONTINUATION_H

#include "emit/base/loop.h"

/** Writes the header, whose text begins at `begin`, twice: as it is when the loop may continue, and
 * for compilations without the parallel form. Returns where the text after the header begins. If
 * the header sets nothing, writes nothing and returns `begin`. */
uint32_t write_continued_header(loop_text *loop, writer *out, uint32_t begin);

#endif
