/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The operations on private copies, for each operator and type: filling with the neutral element,
 * and merging a copy into the array. Integers are combined as unsigned numbers, so that nothing
 * overflows.
 *
 * If merging an element of a copy would change nothing, it is skipped. So only updated elements are
 * written: an array of structures has other data between its rows, which must not be written.
 */
#ifndef REDCC_ELEMENTS_H
#define REDCC_ELEMENTS_H

#include "redcc/bins.h"

#include <stddef.h>

struct element_rule {
    size_t size; /* size of an element in bytes */
    /** Sets `count` elements to the neutral element. */
    void (*fill)(void *to, size_t count);
    /** to[i] = to[i] op from[i], for a merge of one copy after the other (figure 9 (b) of the
     * paper, docs/methods.md). `limit` is the limit of the array. */
    void (*merge)(void *to, const void *from, size_t count, redcc_word limit);
    /** to[i] = to[i] op from[0][i] op from[1][i] ..., one element after the other (figure 9 (a)).
     * `limit` as for merge. */
    void (*merge_all)(void *to, const void *const *from, size_t copies, size_t count,
                      redcc_word limit);
    /** As merge_all, for an array that owns all memory between its touched elements, so that no
     * element need be skipped. Makes the copies neutral again. */
    void (*drain)(void *to, void *const *from, size_t copies, size_t count, redcc_word limit);
    /** Applies records of `count` elements each to rows of the same length, in order; NULL: the
     * operator is not supported. */
    void (*apply)(const redcc_applied *applied, size_t count);
};

/** The rule for an operator and a type; NULL if there is no rule (for example for REDCC_OTHER_TYPE,
 * or the minimum of complex numbers). */
const struct element_rule *redcc_element_rule(redcc_operator operation, redcc_type type);

#endif
