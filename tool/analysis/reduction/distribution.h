/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loop distribution (fission): finds stores that can be made after the loop.
 *
 *      y[r[i]] -= t[i]; t[i] = 0;
 *
 *  Several threads may execute an iteration, each for the elements of y that it owns. None of them
 *  knows when the others have read t[i]. But no other iteration uses t[i], so all these stores can
 *  be made after the last iteration. */
#ifndef ANALYSIS_DISTRIBUTION_H
#define ANALYSIS_DISTRIBUTION_H

#include "analysis/loop/loop_analysis.h"

/** The loop's stores of this form. Does not prove that they may be made later. NULL if there are
 *  none. */
const distribution *distribution_find(const loop_analysis *j);

/** The reason for which the stores in j->left_out.distribution, which have been removed from the
 *  loop (base/distributed.h), must not be made after all iterations. REASON_NONE if they may.
 *  Whether the loop's arrays overlap the stored elements is not checked here, but together with all
 *  reads of the loop. */
reason check_distribution(const loop_analysis *j);

#endif
