/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_CUTS_H
#define REDCC_CUTS_H

#include "ownership/partition.h"
#include "ownership/sample.h"

/**
 * Cuts the groups of a partition, from the samples of `threads` threads (sample [threads]).
 *
 * The leading group (the first one that yields as many different parts as there are owners) is cut
 * at quantiles of its sampled touches. A cut of another group goes where it separates best what
 * the iterations on either side of the leading group's cut touch, so that iterations which need
 * two owners because of one array need the same two because of the others.
 *
 * Returns false where there is no memory. Cost: O(touches * owners), some 10^5 touches at most.
 */
bool redcc_choose_cuts(struct partition *partition, const struct sample *const *sample,
                       int threads);

#endif
