/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What private copies need of each operator and type: the neutral element, and how one copy is
 * brought into the array. Integers are combined as unsigned numbers, so that nothing overflows.
 *
 * An element of a copy that still holds the neutral element is left out, so that nothing is
 * written where no iteration updated: between the rows of an array of structures lie other things.
 */
#ifndef REDCC_ELEMENTS_H
#define REDCC_ELEMENTS_H

#include "redcc/bins.h"

#include <stddef.h>

struct element_rule {
    size_t size; /* bytes of an element */
    /** Sets `count` elements to the neutral element. */
    void (*fill)(void *to, size_t count);
    /** to[i] = to[i] op from[i]: figure 9 (b) of the paper does this copy by copy. limit: the
     *  array's. */
    void (*merge)(void *to, const void *from, size_t count, redcc_word limit);
    /** to[i] = to[i] op from[0][i] op from[1][i] ...: figure 9 (a), element by element. */
    void (*merge_all)(void *to, const void *const *from, size_t copies, size_t count,
                      redcc_word limit);
    /** Brings records of `count` elements each into rows of as many, in order; NULL: such updates
     *  have none. */
    void (*apply)(const redcc_applied *applied, size_t count);
};

/** The rule for an operator and a type; NULL where there is none (REDCC_OTHER_TYPE, the minimum of
 *  complex numbers, ...). */
const struct element_rule *redcc_element_rule(redcc_operator operation, redcc_type type);

#endif
