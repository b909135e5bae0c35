/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Estimates the cost of each strategy from what an inspection has found so far. */
#ifndef REDCC_CHOOSE_COST_MODEL_H
#define REDCC_CHOOSE_COST_MODEL_H

#include "learn/learner.h"

/** The measured seconds of an iteration's slice. 0: not measured. */
struct slice_seconds {
    double recorded; /**< if its touches are recorded; 0 also if this takes about as long as the
                        number of touches suggests */
    double compared; /**< if its touches are only compared with one owner's range */
};

struct findings {
    long long trip; /**< number of iterations */
    int threads;
    double sequential; /**< seconds per iteration of the original loop */
    double spent;      /**< seconds that this inspection has taken so far */
    double share;  /**< fraction of the iterations that the most loaded thread executes, with owners
                      by address */
    double direct; /**< as `share`, for threads that find their iterations during execution; 0: they
                      cannot */
    double touches;      /**< number of touches per iteration */
    double leading_rows; /**< number of different rows of the leading group per iteration */
    double further_rows; /**< number of different rows of the other groups per iteration */
    struct slice_seconds slice;
    /** fraction of the iterations that touch other owners than the iteration before */
    double runs;
    bool fetched;  /**< accesses are irregular, the data exceed the caches, and plans prefetch */
    bool tiled;    /**< the loop is over pairs, and can be cut into tiles */
    bool lanes;    /**< plans use the loop's vector form, because that is faster */
    double copied; /**< size of a private copy in bytes; 0: private copies are not permitted or not
                      possible */
    bool binned;   /**< the loop can be binned */
    bool bins_known; /**< the sample suggests that binning pays */
    /** seconds that binning adds to each execution: merging private copies, and executing the
     * slices for the overlap guard */
    double bin_more;
    bool reusable;  /**< the plan can be kept */
    double checked; /**< number of bytes of subscripts that are compared before a plan is reused */
};

/** Fills in the estimates arm [WAY_COUNT]. */
void redcc_estimate_arms(const struct findings *findings, struct arm *arm);

#endif
