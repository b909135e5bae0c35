/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** How a call's plan is found. */
#ifndef REDCC_ROUTE_H
#define REDCC_ROUTE_H

/** How an inspection arrives at a plan. A stage's end decides it, once it knows enough. */
enum route {
    ROUTE_SERIAL, /* at none: the original loop */
    ROUTE_OWNERS, /* owners cut by address */
    ROUTE_DIRECT, /* the same, whose threads find their iterations while they execute */
    ROUTE_COPIES, /* private copies: nobody has to know who touches what */
    ROUTE_GRAPH,  /* owners cut from the access graph */
    ROUTE_LEVELS  /* iterations in levels */
};

#endif
