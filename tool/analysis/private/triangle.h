/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises an inner loop that forms a triangle with the analysed loop (facts.h). Its trip count
 *  in each iteration is known before the analysed loop begins. */
#ifndef ANALYSIS_TRIANGLE_H
#define ANALYSIS_TRIANGLE_H

#include "analysis/loop/loop_analysis.h"

/** Is `node`, in the body, executed once in each iteration of an inner loop that forms a triangle,
 *  and is that inner loop executed once in each iteration of the analysed loop? If so, stores the
 *  inner loop in *it. */
bool triangle_around(const loop_analysis *j, const ir_node *node, triangle *it);

#endif
