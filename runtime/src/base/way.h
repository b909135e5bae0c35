/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The strategies (enum way) from which `auto` chooses. They are the arms of its bandit
 * (learn/learner.h). */
#ifndef REDCC_WAY_H
#define REDCC_WAY_H

#include <stdbool.h>

enum way {
    WAY_SEQUENTIAL,
    /* Strategies with a plan, which an inspection builds: */
    WAY_COPIES, /**< private copies */
    WAY_INDEX,  /**< LOCALWRITE with owners by address */
    WAY_GRAPH,  /**< LOCALWRITE with owners chosen by partitioning the access graph; or wavefronts,
                   if the owners would get uneven work */
    /* Strategies without a plan that depends on the subscripts, which may therefore change: */
    WAY_DIRECT, /**< LOCALWRITE without a plan: threads find their iterations during execution; or
                   tiles, for a loop over pairs */
    WAY_BINS,   /**< in-order binning; a trial of it may stop in the middle of the loop */
    WAY_COUNT,
    WAY_LAST_PLANNED = WAY_GRAPH
};

static inline bool redcc_is_planned(enum way way) {
    return way != WAY_SEQUENTIAL && way <= WAY_LAST_PLANNED;
}

#endif
