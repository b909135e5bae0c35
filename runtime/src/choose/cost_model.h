/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Estimates the cost of each strategy from the results of an inspection so far. */
#ifndef REDCC_CHOOSE_COST_MODEL_H
#define REDCC_CHOOSE_COST_MODEL_H

#include "learn/learner.h"

struct findings {
    long long trip; /**< iterations */
    int threads;
    double sequential;   /**< seconds of the original loop per iteration */
    double spent;        /**< seconds of this inspection so far */
    double share;        /**< share of the iterations of the most loaded thread, by index */
    double direct;       /**< the same without an inspection; 0: not possible */
    double touches;      /**< per iteration */
    double leading_rows; /**< ... at different addresses, of the group that owners are cut in */
    double further_rows; /**< ... of the others */
    double slice;        /**< seconds of an iteration's slice; 0: unknown, or its touches say it */
    double runs;     /**< share of the iterations that touch other owners than the preceding one */
    bool fetched;    /**< its accesses are irregular and exceed the caches, and plans prefetch
                      * them */
    bool tiled;      /**< it is a loop over pairs, to be cut into tiles */
    bool lanes;      /**< plans execute by lanes, if that is faster */
    double copied;   /**< bytes of a private copy; 0: none is permitted, or possible */
    bool binned;     /**< it has a form for binning, */
    bool bins_known; /**< which is expected to pay */
    double bin_more; /**< seconds in addition to the loop's own work: private copies, a check */
    bool reusable;   /**< the plan can be kept */
    double checked;  /**< bytes of subscripts that are compared before a plan is reused */
};

/** Fills arm [WAY_COUNT]. */
void redcc_estimate_arms(const struct findings *findings, struct arm *arm);

#endif
