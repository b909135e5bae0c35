/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * REDCC_VALIDATE=1: after each execution in parallel the first thread executes the loop once more,
 * all iterations in order, into a copy of the arrays as they were before; then the two are
 * compared.
 *
 * Where the sequential loop's bits are promised, an element with others breaks the promise, and so
 * does an integer in whatever order; of floating sums in another order the largest difference is
 * told. Numbers that are none count as equal, whatever their bits. Executions beside another one of
 * the same loop are not compared, nor are those of a loop of whose arrays one is scattered: between
 * its elements lies what must not be copied.
 *
 * Of a loop with a plan it is known before what is written; of a binned one before each round, and
 * the copies grow. Where it goes on sequentially, the iterations up to there are compared.
 */
#ifndef REDCC_VALIDATE_H
#define REDCC_VALIDATE_H

#include "redcc/runtime.h"

#include "base/range.h"

#include <stdatomic.h>
#include <stdbool.h>

struct plan;

/** What REDCC_VALIDATE=1 found. */
struct validated {
    long executions;      /* compared with the sequential loop */
    long passed_over;     /* not compared: of a scattered array no copy can be made */
    long broken;          /* of these, where the promise was not kept */
    atomic_long misnamed; /* updates of rows that a slice did not name (redcc/parallel.h) */
    double largest;       /* difference, in ulps */
    const char *array;
    char name[64];     /* of the array where it was found */
    redcc_int element; /* counted from the array's first one */
};

/** What one array held. */
struct held {
    char *memory; /* before the loop; then the loop's results; NULL: nothing was touched */
    char *place;  /* where that is in the array */
    size_t bytes;
    bool in_order; /* the sequential loop's bits are promised, of whatever type */
};

/** Of one execution. All zero: none. */
struct validation {
    bool began;
    bool gave_up;       /* no memory */
    const char *method; /* that executes the loop */
    uint32_t count;
    struct held *held; /* [count] by array, or by a plan's group */
};

/** Copies what the plan's groups hold, for arrays at `bases`; without memory for that there is no
 *  validation, nor where an array is scattered, which is counted in *validated. One thread; nobody
 *  may write meanwhile. */
void redcc_validation_begin(struct validation *validation, const struct plan *plan,
                            void *const *bases, struct validated *validated);

/** Without a plan: bytes `written` of one of `count` arrays are to be written next, in the order of
 *  the sequential loop. Copies what has not been copied. As redcc_validation_begin otherwise. */
void redcc_validation_grow(struct validation *validation, uint32_t count, uint32_t array,
                           struct range written);

/** The loop is executed: puts what the arrays held before back, and its results aside. */
void redcc_validation_swap(struct validation *validation);

/** The loop is executed once more: compares the arrays at `bases` with the results put aside, which
 *  it then puts back, enters what it finds into *validated, and gives the memory back. */
void redcc_validation_end(struct validation *validation, const redcc_loop *loop, void *const *bases,
                          struct validated *validated);

#endif
