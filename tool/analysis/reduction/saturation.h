/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises a counter that stops at a limit: if (R < C) R++, with a constant C.
 *
 *  After n such updates, in any order, R is unchanged if it was at least C, and otherwise it is
 *  min(C, R + n). The same holds for a private copy that begins with the type's least value L. If
 *  the copy is below C, then n = R - L. If it has reached C, then n >= C - L, and the element
 *  reaches C whatever its value was. So copies can be merged (runtime/src/plan/elements.c). */
#ifndef ANALYSIS_SATURATION_H
#define ANALYSIS_SATURATION_H

#include "ir/ir.h"

/** Recognises the statement of such an update of `target`. Sets *limit to C, which is greater than
 *  0 and a value of the target's type. */
bool saturation_of(const ir_node *statement, const ir_node *target, int64_t *limit);

#endif
