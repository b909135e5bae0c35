/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the user asks for, as far as it decides the form of the loops that are written. */
#ifndef PLAN_OPTIONS_H
#define PLAN_OPTIONS_H

#include <stdbool.h>

/** What a result may differ in from the sequential loop's (REDCC_ORDER_... of the runtime). */
typedef enum result_order { ORDER_SERIAL, ORDER_FIXED, ORDER_ANY } result_order;

/** Which loops are to execute four iterations at once, where they can. */
typedef enum lanes_wish {
    LANES_OF_NONE,
    LANES_OF_HEAVY, /* of long iterations */
    LANES_OF_ALL
} lanes_wish;

typedef struct plan_options {
    result_order order;
    bool order_is_explicit; /* asked for explicitly, not just the default */
    const char *obstacle;   /* why nothing may be written; NULL: nothing forbids it */
    const char *linked;     /* text behind the file's own that defines redcc__linked, which tells
                               whether functions of other files are those that were analysed; NULL:
                               nothing rests on other files */
    lanes_wish lanes;
    const unsigned char *leave; /* by verdict: 1: write nothing for several iterations at once.
                                   NULL: 0 everywhere */
} plan_options;

#endif
