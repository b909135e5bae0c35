/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Estimates the cost of each strategy from the results of an inspection so far. */
#ifndef REDCC_CHOOSE_COST_MODEL_H
#define REDCC_CHOOSE_COST_MODEL_H

#include "learn/learner.h"

struct findings {
    long long trip; /**< iterations */
    int threads;
    double sequential; /**< seconds of the original loop per iteration */
    double spent;      /**< seconds of this inspection so far */
    double share;  /**< fraction of the iterations that the most loaded thread executes, with owners
                      by address */
    double direct; /**< the same without an inspection; 0: not possible */
    double touches;      /**< per iteration */
    double leading_rows; /**< different rows of the leading group per iteration */
    double further_rows; /**< different rows of the other groups per iteration */
    /** seconds of an iteration's slice; 0: unknown, or as estimated from its touches */
    double slice;
    double runs;  /**< fraction of the iterations that touch other owners than the preceding one */
    bool fetched; /**< accesses are irregular, their data exceed the caches, and plans prefetch them
                   */
    bool tiled;   /**< the loop is over pairs, to be cut into tiles */
    bool lanes;   /**< plans execute by lanes, if that is faster */
    double copied;   /**< bytes of a private copy; 0: none is permitted, or possible */
    bool binned;     /**< the loop can be binned */
    bool bins_known; /**< the sample suggests that binning pays */
    /** seconds per execution that binning adds: merging private copies, and executing the
     * slices for the overlap guard */
    double bin_more;
    bool reusable;  /**< the plan can be kept */
    double checked; /**< bytes of subscripts that are compared before a plan is reused */
};

/** Fills arm [WAY_COUNT]. */
void redcc_estimate_arms(const struct findings *findings, struct arm *arm);

#endif
