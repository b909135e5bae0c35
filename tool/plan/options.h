/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The user's options that affect the form in which loops are written. */
#ifndef PLAN_OPTIONS_H
#define PLAN_OPTIONS_H

#include <stdbool.h>

/** How results may differ from the sequential loop's. ORDER_SERIAL: not at all. ORDER_FIXED: in
 * rounding, but they are equal for all numbers of threads. ORDER_ANY: in rounding, from run to
 * run. These are the runtime's REDCC_ORDER_... . */
typedef enum result_order { ORDER_SERIAL, ORDER_FIXED, ORDER_ANY } result_order;

/** Which loops shall execute several iterations at once, if possible. */
typedef enum lanes_wish {
    LANES_OF_NONE,
    LANES_OF_HEAVY, /* loops with long iterations */
    LANES_OF_ALL
} lanes_wish;

typedef struct plan_options {
    result_order order;
    bool order_is_explicit; /* the user has set `order` */
    const char *obstacle;   /* the reason why nothing may be written, or NULL */
    const char *linked;     /* text to append to the file, or NULL if no loop depends on other
                             * files. It defines redcc__linked, which checks that functions of other
                             * files are those that were analysed */
    lanes_wish lanes;
    const unsigned char *no_lanes; /* indexed by verdict; 1: write no form for several iterations at
                                    * once; NULL: all are 0 */
} plan_options;

#endif
