/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Inner loops over a triangle: the number of turns in each iteration is known before the loop. */
#ifndef ANALYSIS_TRIANGLE_H
#define ANALYSIS_TRIANGLE_H

#include "analysis/loop/loop_analysis.h"

/** Is the node of the body executed once in each turn of such a loop, and that loop once in each
 *  iteration? Then *it is that loop. */
bool triangle_around(const loop_analysis *j, const ir_node *node, triangle *it);

#endif
