/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_CUTS_H
#define REDCC_CUTS_H

#include "ownership/partition.h"
#include "ownership/sample.h"

/**
 * Cuts the groups of a partition, from the samples of `threads` threads (sample [threads]).
 *
 * The leading group is the first one that yields one part per owner. It is cut at quantiles of its
 * sampled touches. Each cut of another group is placed so as to best separate the touches of the
 * iterations on the two sides of the leading group's cut. Iterations that need two owners because
 * of one array then need the same two because of the others.
 *
 * Returns false without memory. Cost: O(touches * owners), some 10^5 touches at most.
 */
bool redcc_choose_cuts(struct partition *partition, const struct sample *const *sample,
                       int threads);

#endif
