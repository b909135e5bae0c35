/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Operations of private copies for each operator and type: the neutral element, and the merge of a
 * copy into the array. Integers are combined as unsigned numbers, so that nothing overflows.
 *
 * An element of a copy that would change nothing is skipped, so that only updated elements are
 * written: an array of structures has other data between its rows.
 */
#ifndef REDCC_ELEMENTS_H
#define REDCC_ELEMENTS_H

#include "redcc/bins.h"

#include <stddef.h>

struct element_rule {
    size_t size; /* bytes of an element */
    /** Sets `count` elements to the neutral element. */
    void (*fill)(void *to, size_t count);
    /** to[i] = to[i] op from[i], for a merge copy by copy (figure 9 (b) of the paper). limit: the
     *  array's. */
    void (*merge)(void *to, const void *from, size_t count, redcc_word limit);
    /** to[i] = to[i] op from[0][i] op from[1][i] ..., element by element (figure 9 (a)). */
    void (*merge_all)(void *to, const void *const *from, size_t copies, size_t count,
                      redcc_word limit);
    /** As merge_all, if all memory belongs to the array: no element is skipped. Makes the copies
     * neutral again. */
    void (*drain)(void *to, void *const *from, size_t copies, size_t count, redcc_word limit);
    /** Applies records of `count` elements each to rows of the same length, in order; NULL: not
     *  supported. */
    void (*apply)(const redcc_applied *applied, size_t count);
};

/** The rule for an operator and a type; NULL if there is none (REDCC_OTHER_TYPE, the minimum of
 *  complex numbers, ...). */
const struct element_rule *redcc_element_rule(redcc_operator operation, redcc_type type);

#endif
