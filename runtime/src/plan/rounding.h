/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** For compensated sums: a plan's storage for the rounding error of each element. */
#ifndef REDCC_ROUNDING_H
#define REDCC_ROUNDING_H

#include "redcc/runtime.h"

#include <assert.h>
#include <stdbool.h>
#include <stddef.h>

struct plan;

/** The rounding errors of a group's elements. */
struct rounding {
    double *value;    /* [count] the accumulated rounding error of each touched element; NULL: the
                         group is not compensated */
    double *before;   /* [count] the value of each element before the current update */
    size_t count;     /* number of elements */
    ptrdiff_t offset; /* offset of the first element from the group's base */
    char *first;      /* address of the first element in this execution */
    redcc_type type;  /* REDCC_FLOAT or REDCC_DOUBLE */
};

/** The size of an element in bytes. */
static inline size_t redcc_rounding_element(redcc_type type) {
    assert(type == REDCC_FLOAT || type == REDCC_DOUBLE);
    return type == REDCC_FLOAT ? sizeof(float) : sizeof(double);
}

/** Allocates memory for the errors of those groups of the plan that are sums of floats or doubles.
 * Returns false if out of memory. */
bool redcc_rounding_new(struct plan *plan, const redcc_array *arrays);

/** Frees the errors. */
void redcc_rounding_free(struct plan *plan);

/** The total size of the errors in bytes. */
size_t redcc_rounding_bytes(const struct plan *plan);

#endif
