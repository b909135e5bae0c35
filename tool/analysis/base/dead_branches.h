/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds branches that are never executed, so that the analysis of loops can ignore them: those of
 *  `if (DEBUG)` where DEBUG is 0, and those as in
 *
 *      ok = product(a, b, c);
 *      if (!ok) fprintf(stderr, "no product\n");
 *
 *  if every `return` of `product` returns 1. */
#ifndef ANALYSIS_DEAD_BRANCHES_H
#define ANALYSIS_DEAD_BRANCHES_H

#include "ir/ir.h"

/** Replaces each branch of an `if` that is never executed by an empty block with the branch's
 *  range, flagged IR_DEAD. Branches that contain labels or opaque nodes are not replaced. If a
 *  function of another file makes the condition constant, branches that affect file-scope variables
 *  are not replaced either. May be called again after functions got bodies from other files
 *  (ir_adopt.h). */
void dead_branches_take_out(ir_unit *unit);

#endif
