/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The strategies that `auto` chooses from. They are the arms of its bandit (learn/learner.h). */
#ifndef REDCC_WAY_H
#define REDCC_WAY_H

#include <stdbool.h>

enum way {
    WAY_SEQUENTIAL,
    /* Strategies with a plan, which an inspection builds: */
    WAY_COPIES, /**< private copies */
    WAY_INDEX,  /**< LOCALWRITE with owners by address */
    WAY_GRAPH,  /**< LOCALWRITE with owners chosen by partitioning the access graph; or wavefronts,
                   if the owners' work would be uneven */
    /* Strategies without a plan that depends on the subscripts, which may therefore change: */
    WAY_DIRECT, /**< LOCALWRITE in which threads find their iterations during execution; or
                 * tiles, for a loop over pairs */
    WAY_BINS,   /**< in-order binning, whose trials may stop in the middle */
    WAY_COUNT,
    WAY_LAST_PLANNED = WAY_GRAPH
};

static inline bool redcc_is_planned(enum way way) {
    return way != WAY_SEQUENTIAL && way <= WAY_LAST_PLANNED;
}

#endif
