/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What each way would cost, by what an inspection has found so far. */
#ifndef REDCC_PROSPECTS_H
#define REDCC_PROSPECTS_H

#include "choose/decide.h"

struct findings {
    long long trip; /**< iterations */
    int threads;
    double sequential;   /**< seconds of the original loop for an iteration */
    double spent;        /**< seconds of this inspection so far */
    double share;        /**< of the iterations, by the thread that would execute most by index */
    double touches;      /**< of an iteration */
    double leading_rows; /**< ... at different addresses, of the group that owners are cut in */
    double further_rows; /**< ... of the others */
    double runs;      /**< of the iterations: those that touch other owners than the one before */
    bool fetched;     /**< its rows lie in no order beyond the caches, and plans prefetch them */
    bool lanes;       /**< plans execute by lanes, if that is faster */
    bool copies;      /**< private copies may and can be had */
    double copied;    /**< bytes of one of them */
    bool binned;      /**< it has a form for binning, which may be worth a trial */
    double bin_bytes; /**< of private copies that binning makes in place of records; 0: none */
    bool reusable;    /**< the plan can be kept */
    double checked;   /**< bytes of subscripts that are compared before a plan is used again */
};

/** Fills prospect [WAY_COUNT]. */
void redcc_estimate_prospects(const struct findings *findings, struct prospect *prospect);

/** Seconds that putting iterations in levels takes for a touch. */
extern const double redcc_level_touch;

#endif
