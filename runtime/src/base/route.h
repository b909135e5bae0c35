/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The kinds of plans that an inspection builds. */
#ifndef REDCC_ROUTE_H
#define REDCC_ROUTE_H

/** The route is decided by the first stage of the inspection that has the necessary information. */
enum route {
    ROUTE_SERIAL, /* no plan: the original loop */
    ROUTE_OWNERS, /* owners cut by address */
    ROUTE_DIRECT, /* the same, without schedules: threads find their iterations during execution */
    ROUTE_COPIES, /* private copies: owners do not matter */
    ROUTE_GRAPH,  /* owners cut from the access graph */
    ROUTE_LEVELS  /* iterations in levels */
};

#endif
