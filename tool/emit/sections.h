/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Sections of arrays in OpenMP's clause `reduction`: what the loop updates at most. With them it
 * is executed in a fixed order without an inspection (runtime/src/choose/sections.h). */
#ifndef EMIT_SECTIONS_H
#define EMIT_SECTIONS_H

#include "emit/base/loop.h"

/** Is every array of the loop in such a clause, with a section that can be written? Not if the
 *  sequential order is asked for. */
bool is_sectioned(loop_text *loop);

/** The order that the loop keeps. */
result_order order_of_loop(loop_text *loop);

/** Sets the attempt's sections, if it is sectioned. */
void write_sections(loop_text *loop, writer *out);

#endif
