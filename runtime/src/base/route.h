/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The ways in which an inspection may lead to a plan. */
#ifndef REDCC_ROUTE_H
#define REDCC_ROUTE_H

/** The result of an inspection. The first stage of the inspection that has the necessary
 * information decides it. */
enum route {
    ROUTE_SERIAL, /* no plan: the original loop runs */
    ROUTE_OWNERS, /* owners with consecutive ranges of addresses */
    ROUTE_DIRECT, /* as ROUTE_OWNERS, but without schedules: threads find their iterations during
                     execution */
    ROUTE_COPIES, /* private copies, so that owners do not matter */
    ROUTE_GRAPH,  /* owners chosen by partitioning the access graph */
    ROUTE_LEVELS  /* no owners: iterations are executed level by level */
};

#endif
