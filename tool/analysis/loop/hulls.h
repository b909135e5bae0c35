/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds hulls: loops of the slice around spans (spans.h), such as those over the rows of a window:
 *
 *      for (y = from; y <= to; y++)
 *          for (x = left; x <= right; x++)
 *              g[y * width + x] += ...
 *
 *  To decide whether it owns all, a part or nothing of the window, a thread needs only the hull:
 *  the range from the lowest to the highest address. An affine function of a counter has its
 *  extremes at the counter's first and last values; a function that is affine in several counters
 *  has them at the corners of the counters' ranges. The hull also contains addresses that are not
 *  updated, so a thread may check owners needlessly. */
#ifndef ANALYSIS_HULLS_H
#define ANALYSIS_HULLS_H

#include "analysis/loop/spans.h"

typedef VECTOR(const ir_node *) hull_list;

/** The inner loops whose first and last iterations have the extreme addresses of all updates in
 *  them. They are in source order, outer loops before inner ones. `spans` are the spans of the
 *  slice. */
hull_list find_hulls(const loop_analysis *j, const span_list *spans);

#endif
