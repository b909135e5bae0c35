/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** How a call is executed, and how its plan is found. */
#ifndef REDCC_ROUTE_H
#define REDCC_ROUTE_H

/** How an inspection arrives at a plan. A stage's end decides it, once it knows enough. */
enum route {
    ROUTE_SERIAL, /* at none: the original loop */
    ROUTE_TIMED,  /* at none: one thread executes all iterations within the region, timed */
    ROUTE_OWNERS, /* owners cut by address */
    ROUTE_COPIES, /* private copies: nobody has to know who touches what */
    ROUTE_GRAPH,  /* owners cut from the access graph */
    ROUTE_LEVELS  /* iterations in levels */
};

/** How a call is executed. */
enum mode {
    MODE_SERIAL,   /* the original loop */
    MODE_TIMED,    /* a timed sequential run: one thread of the region executes all, in order */
    MODE_PARALLEL, /* by a plan */
    MODE_SOLO, /* by a plan with stealable blocks; calibration: the first thread executes its first
                  stealable block before all else, timed, while the others wait, */
    MODE_CONTENDED, /* or while they execute what is theirs */
    MODES
};

#endif
