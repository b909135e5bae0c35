/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops whose updates OpenMP's `atomic` or `critical` protects: the program leaves their order
 * open. The iterations are divided into N shares. Each share updates a private copy of the rows,
 * and the copies are merged in order. So the bits are the same with any number of threads. Each
 * update checks that its row is in the copy. If one is not, no array is written, and all shares are
 * executed again, with larger copies. A merge writes only between the first and the last row that
 * was updated.
 *
 * N must not depend on threads or time. It depends on the trip count and the rows that were found
 * earlier: first in a sample that one thread takes, later in whole executions, also in those that
 * fail.
 */
#ifndef REDCC_BINS_SHARES_H
#define REDCC_BINS_SHARES_H

#include "bins/binning.h"

/** The number of shares for `trip` iterations. Below 2: the loop is executed in its own order. */
int redcc_bins_shares(const struct binning *binning, redcc_int trip, size_t memory_limit);

/** Gives the thread another share, and makes the copies of that share neutral. Each thread begins
 * with other shares, and later takes those that are left. False: none is left. */
bool redcc_shares_take(struct binning *binning, struct binner *binner);

#endif
