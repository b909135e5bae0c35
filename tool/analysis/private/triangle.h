/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises inner loops over a triangle (facts.h), whose trip count in each iteration is known
 *  before the loop. */
#ifndef ANALYSIS_TRIANGLE_H
#define ANALYSIS_TRIANGLE_H

#include "analysis/loop/loop_analysis.h"

/** Is the node of the body executed once in each iteration of such an inner loop, and that loop
 *  once in each iteration of the analysed loop? If so, stores the inner loop in *it. */
bool triangle_around(const loop_analysis *j, const ir_node *node, triangle *it);

#endif
