/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loop distribution (fission): stores that can be made after the loop.
 *
 *     y[r[i]] -= t[i];  t[i] = 0;
 *
 * Several threads may execute an iteration, each for the elements of y that it owns: none of them
 * knows when the others have read t[i]. But no other iteration uses t[i], so all such stores may
 * be made after the last iteration.
 */
#ifndef ANALYSIS_DISTRIBUTION_H
#define ANALYSIS_DISTRIBUTION_H

#include "analysis/loop/loop_analysis.h"

/** The stores of a loop that have this form, not yet checked; NULL: none. */
const distribution *distribution_find(const loop_analysis *j);

/** The reason why the stores of j->left_out.distribution, which were removed from the loop
 *  (base/distributed.h), may not be made after all iterations. Other checks compare the loop's
 *  reads with its arrays. */
reason check_distribution(const loop_analysis *j);

#endif
