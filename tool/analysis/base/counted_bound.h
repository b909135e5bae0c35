/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks the bound of a do loop, which the program first evaluates after the first iteration. Only
 *  counted.c uses this header. */
#ifndef ANALYSIS_COUNTED_BOUND_H
#define ANALYSIS_COUNTED_BOUND_H

#include "ir/ir.h"

/** Can the bound be evaluated before the first iteration, whatever memory contains? This does not
 *  check that its value stays the same. */
bool counted_bound_is_safe_before(const ir_node *bound);

#endif
