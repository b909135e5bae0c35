/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A counter that stops at a limit: if (R < C) R++, with a constant C. After n such updates R is
 * R where R >= C, else min(C, R + n), whatever their order. Of a private copy that begins with the
 * type's lowest value L the same holds; where it has not come to C it tells n as R - L, and where
 * it has, n >= C - L is enough for every element to come to C. So copies can be brought together
 * (runtime/src/plan/elements.c).
 */
#ifndef ANALYSIS_SATURATION_H
#define ANALYSIS_SATURATION_H

#include "ir/ir.h"

/** Looks at the statement of an update of `target`. Sets *limit to C, which is above 0 and a value
 * of the target's type. */
bool saturation_of(const ir_node *statement, const ir_node *target, int64_t *limit);

#endif
