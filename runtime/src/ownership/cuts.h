/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_CUTS_H
#define REDCC_CUTS_H

#include "ownership/partition.h"
#include "ownership/sample.h"

/**
 * Cuts the groups of a partition, according to the samples of `threads` threads, sample[threads].
 *
 * Each group is first cut at quantiles of its sampled touches. The leading group is the group with
 * the most different cuts, the first one if several have as many. Each cut of another group is then
 * moved to the place where it best separates the iterations on one side of the leading group's cut
 * from those on the other side. An iteration that touches the parts of two owners in one array thus
 * usually touches the parts of the same two owners in the others.
 *
 * Returns false if out of memory. The time is O(touches * owners); there are at most some 10^5
 * sampled touches.
 */
bool redcc_choose_cuts(struct partition *partition, const struct sample *const *sample,
                       int threads);

#endif
