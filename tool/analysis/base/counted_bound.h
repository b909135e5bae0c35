/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The bound of a do loop, which the program evaluates after the first iteration. Of counted.c
 *  only. */
#ifndef ANALYSIS_COUNTED_BOUND_H
#define ANALYSIS_COUNTED_BOUND_H

#include "ir/ir.h"

/** Can the bound be evaluated before the first iteration, whatever memory holds then? That its
 *  value is the same then and later is not asked here. */
bool counted_bound_is_safe_before(const ir_node *bound);

#endif
