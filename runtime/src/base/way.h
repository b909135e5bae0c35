/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The ways of executing a loop that auto chooses from. */
#ifndef REDCC_WAY_H
#define REDCC_WAY_H

enum way {
    WAY_SEQUENTIAL,
    WAY_COPIES, /**< private copies */
    WAY_INDEX,  /**< LOCALWRITE, owners by address */
    WAY_GRAPH,  /**< LOCALWRITE, owners cut from the access graph; wavefronts where these are uneven
                 */
    WAY_BINS, /**< in-order binning: without an inspection or a plan, so that subscripts may change
               */
    WAY_COUNT,
    WAY_LAST_PLANNED = WAY_GRAPH
};

#endif
