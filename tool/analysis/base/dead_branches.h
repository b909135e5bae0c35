/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Branches that are never executed: of `if (DEBUG)` where that is 0, and of
 *
 *     ok = product(a, b, c);
 *     if (!ok) fprintf(stderr, "no product\n");
 *
 * where every `return` of `product` gives 1. The analysis of loops ignores them.
 */
#ifndef ANALYSIS_DEAD_BRANCHES_H
#define ANALYSIS_DEAD_BRANCHES_H

#include "ir/ir.h"

/** Replaces each branch of an `if` that is never executed by an empty block, flagged IR_DEAD, whose
 *  range is the branch's. Branches with labels or opaque nodes stay. So do branches that concern
 * variables of the file, if a function of another file makes the condition constant. May be called
 * again after functions got bodies from other files (ir_adopt.h). */
void dead_branches_take_out(ir_unit *unit);

#endif
