/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops of the slice around spans (spans.h), as over the rows of a window:
 *
 *     for (y = from; y <= to; y++)
 *         for (x = left; x <= right; x++)
 *             g[y * width + x] += ...
 *
 * A thread that asks whether it owns all of the window, a part or nothing needs only the hull, the
 * range from the lowest address to the highest. An affine function of a counter has its extremes at
 * the first value and the last; one that is affine in each of several counters, at the corners. The
 * hull also contains addresses that are not updated: the thread may then check owners needlessly.
 */
#ifndef ANALYSIS_HULLS_H
#define ANALYSIS_HULLS_H

#include "analysis/loop/spans.h"

typedef VECTOR(const ir_node *) hull_list;

/** The inner loops whose first and last iterations have the extreme addresses of all updates in
 *  them, in source order, each before those inside of it. `spans`: those of the slice. */
hull_list find_hulls(const loop_analysis *j, const span_list *spans);

#endif
