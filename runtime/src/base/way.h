/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The strategies that auto chooses from: the arms of its bandit. */
#ifndef REDCC_WAY_H
#define REDCC_WAY_H

#include <stdbool.h>

enum way {
    WAY_SEQUENTIAL,
    /* With a plan, which an inspection builds: */
    WAY_COPIES, /**< private copies */
    WAY_INDEX,  /**< LOCALWRITE, owners by address */
    WAY_GRAPH, /**< LOCALWRITE, owners cut from the access graph; or wavefronts, if the owners' work
                * would be uneven */
    /* Without a plan that depends on the subscripts, so that these may change: */
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
