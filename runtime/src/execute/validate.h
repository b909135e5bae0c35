/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * REDCC_VALIDATE=1: after each parallel execution the first thread executes the loop once more, all
 * iterations in order, into a copy of the arrays' previous contents. Then the two results are
 * compared.
 *
 * If the sequential loop's bits are promised, an element with other bits breaks the promise, and so
 * does a different integer in any order; for floating sums in another order only the largest
 * difference is reported. NaNs count as equal, whatever their bits. An execution concurrent with
 * another one of the same loop is not compared, nor is that of a loop with a scattered array:
 * memory between its elements must not be copied.
 *
 * For a loop with a plan the written range is known before it runs; for a binned one before each
 * round, and the copies grow. If it continues sequentially, the iterations up to there are
 * compared.
 */
#ifndef REDCC_VALIDATE_H
#define REDCC_VALIDATE_H

#include "redcc/runtime.h"

#include "base/range.h"

#include <stdatomic.h>
#include <stdbool.h>

struct plan;

/** Results of REDCC_VALIDATE=1. */
struct validated {
    long executions;      /* compared with the sequential loop */
    long passed_over;     /* not compared: a scattered array cannot be copied */
    long broken;          /* executions that broke a promise */
    atomic_long misnamed; /* updates of rows that a slice did not name (redcc/parallel.h) */
    double largest;       /* difference, in ulps */
    const char *array;
    char name[64];     /* of the array where it was found */
    redcc_int element; /* counted from the array's first one */
};

/** Saved contents of one array. */
struct held {
    char *memory; /* before the loop; then the loop's results; NULL: nothing was touched */
    char *place;  /* its address in the array */
    size_t bytes;
    bool in_order; /* the sequential loop's bits are promised, for any type */
};

/** Of one execution. Zero: none. */
struct validation {
    bool began;
    bool gave_up;       /* no memory */
    const char *method; /* of the loop's execution */
    uint32_t count;
    struct held *held; /* [count] by array, or by a plan's group */
};

/** Copies the contents of the plan's groups, for arrays at `bases`. Without memory there is no
 *  validation, nor for a scattered array, which is counted in *validated. One thread; no other
 *  thread may write meanwhile. */
void redcc_validation_begin(struct validation *validation, const struct plan *plan,
                            void *const *bases, struct validated *validated);

/** Without a plan: bytes `written` of one of `count` arrays are to be written next, in the order of
 *  the sequential loop. Copies those that are not copied yet. Otherwise as
 *  redcc_validation_begin. */
void redcc_validation_grow(struct validation *validation, uint32_t count, uint32_t array,
                           struct range written);

/** After the loop: saves its results, and restores the arrays' previous contents. */
void redcc_validation_swap(struct validation *validation);

/** After the repetition: compares the arrays at `bases` with the saved results, restores these,
 *  records differences in *validated, and frees the memory. */
void redcc_validation_end(struct validation *validation, const redcc_loop *loop, void *const *bases,
                          struct validated *validated);

#endif
