/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Passes to the runtime the sections of arrays that an OpenMP directive reduces
 * (plan/sections.h). */
#ifndef EMIT_SECTIONS_H
#define EMIT_SECTIONS_H

#include "emit/base/loop.h"

/** Writes the statements that pass the sections to the runtime, if the loop has them. */
void write_sections(loop_text *loop, writer *out);

#endif
