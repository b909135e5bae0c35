/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compensated sums: a plan's storage for the rounding errors of each element. */
#ifndef REDCC_ROUNDING_H
#define REDCC_ROUNDING_H

#include "redcc/runtime.h"

#include <assert.h>
#include <stdbool.h>
#include <stddef.h>

struct plan;

/** Rounding errors of a group's elements. */
struct rounding {
    double *value;  /* [count] error of each touched element; NULL: the group is not compensated */
    double *before; /* [count] previous value of an element during its update */
    size_t count;   /* number of elements */
    ptrdiff_t offset; /* of the first element from the group's base */
    char *first;      /* address of the first element in this execution */
    redcc_type type;  /* REDCC_FLOAT or REDCC_DOUBLE */
};

/** Bytes of an element. */
static inline size_t redcc_rounding_element(redcc_type type) {
    assert(type == REDCC_FLOAT || type == REDCC_DOUBLE);
    return type == REDCC_FLOAT ? sizeof(float) : sizeof(double);
}

/** Allocates the errors for the plan's groups that are sums of floats or doubles. False: out of
 *  memory. */
bool redcc_rounding_new(struct plan *plan, const redcc_array *arrays);

/** Frees the errors. */
void redcc_rounding_free(struct plan *plan);

/** The bytes of the errors. */
size_t redcc_rounding_bytes(const struct plan *plan);

#endif
