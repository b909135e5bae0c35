/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A counter that stops at a limit: if (R < C) R++, with a constant C. After n such updates, in any
 * order, R is unchanged if it was at least C, and otherwise min(C, R + n). The same holds for a
 * private copy that begins with the type's lowest value L. If the copy is below C, n = R - L; if it
 * has reached C, n >= C - L, so that the element reaches C from any value. So copies can be merged
 * (runtime/src/plan/elements.c).
 */
#ifndef ANALYSIS_SATURATION_H
#define ANALYSIS_SATURATION_H

#include "ir/ir.h"

/** Recognises the statement of an update of `target`. Sets *limit to C, which is above 0 and a
 *  value of the target's type. */
bool saturation_of(const ir_node *statement, const ir_node *target, int64_t *limit);

#endif
