/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What each way would cost, by what an inspection has found so far. */
#ifndef REDCC_CHOOSE_COST_MODEL_H
#define REDCC_CHOOSE_COST_MODEL_H

#include "learn/learner.h"

struct findings {
    long long trip; /**< iterations */
    int threads;
    double sequential;   /**< seconds of the original loop for an iteration */
    double spent;        /**< seconds of this inspection so far */
    double share;        /**< of the iterations, by the thread that would execute most by index */
    double direct;       /**< the same without an inspection; 0: that cannot be had */
    double touches;      /**< of an iteration */
    double leading_rows; /**< ... at different addresses, of the group that owners are cut in */
    double further_rows; /**< ... of the others */
    double runs;      /**< of the iterations: those that touch other owners than the one before */
    bool fetched;     /**< its rows lie in no order beyond the caches, and plans prefetch them */
    bool lanes;       /**< plans execute by lanes, if that is faster */
    bool copies;      /**< private copies may and can be had */
    double copied;    /**< bytes of one of them */
    bool binned;      /**< it has a form for binning, */
    bool bins_known;  /**< which is expected to be worth it */
    double bin_bytes; /**< of private copies that binning makes in place of records; 0: none */
    bool reusable;    /**< the plan can be kept */
    double checked;   /**< bytes of subscripts that are compared before a plan is used again */
};

/** Fills arm [WAY_COUNT]. */
void redcc_estimate_arms(const struct findings *findings, struct arm *arm);

#endif
