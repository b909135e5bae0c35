/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loop distribution: stores that need not be made in the loop.
 *
 *     y[r[i]] -= t[i];  t[i] = 0;
 *
 * An iteration may be executed by several threads, each for the elements of y that it owns: none of
 * them could tell when the others have read t[i]. But no other iteration asks for t[i], so all such
 * stores may be made after the last one.
 */
#ifndef ANALYSIS_DISTRIBUTION_H
#define ANALYSIS_DISTRIBUTION_H

#include "analysis/loop/loop_analysis.h"

/** The stores of a loop that look like these; NULL: there are none. */
const distribution *distribution_find(const loop_analysis *j);

/** Given the accesses of a loop out of which j->left_out.distribution was taken
 * (base/distributed.h): may its stores be made after all iterations, once it is shown of each array
 * what is shown of all that the loop reads? */
reason check_distribution(const loop_analysis *j);

#endif
