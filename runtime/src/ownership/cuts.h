/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_CUTS_H
#define REDCC_CUTS_H

#include "ownership/partition.h"
#include "ownership/sample.h"

/**
 * Cuts the groups of a partition, according to the samples of `threads` threads, sample[threads].
 *
 * Each group is first cut at quantiles of its sampled touches. The leading group is the group with
 * the most different cuts, the first one if several have as many. Consider the iterations on the
 * two sides of a cut of the leading group. The corresponding cut of each other group is placed
 * where it best separates these two sets of iterations. An iteration that touches the parts of two
 * owners in one array thus usually touches the parts of the same two owners in the others.
 *
 * Returns false if out of memory. The time is O(touches * owners); there are at most some 10^5
 * sampled touches.
 */
bool redcc_choose_cuts(struct partition *partition, const struct sample *const *sample,
                       int threads);

#endif
