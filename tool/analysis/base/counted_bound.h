/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The bound of a do loop, which the program evaluates after the first iteration. Used only by
 *  counted.c. */
#ifndef ANALYSIS_COUNTED_BOUND_H
#define ANALYSIS_COUNTED_BOUND_H

#include "ir/ir.h"

/** Can the bound be evaluated before the first iteration, for any contents of memory? Does not
 *  check that its value stays the same. */
bool counted_bound_is_safe_before(const ir_node *bound);

#endif
