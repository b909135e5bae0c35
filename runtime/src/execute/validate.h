/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * REDCC_VALIDATE=1: after each parallel execution the arrays' previous contents are restored, and
 * the first thread executes all iterations of the loop again, in order. Then the two results are
 * compared.
 *
 * If the sequential loop's bits are promised, an element with other bits is an error. An integer
 * with another value is an error under any order. For floating sums in another order, only the
 * largest difference is reported. Any two NaNs of type float or double count as equal. An execution
 * is not validated if another thread executes the same loop at the same time. Nor is it if an array
 * is scattered, because memory between its elements must not be copied.
 *
 * With a plan, the written range is known before the loop runs. For a binned loop it is known only
 * before each round's updates are applied. So the saved ranges grow from round to round. If a
 * binned loop continues sequentially, only the iterations up to that point are compared.
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
    long executions;  /* number of executions compared with the sequential loop */
    long passed_over; /* number of executions that were not compared, because a scattered array
                         cannot be copied */
    long broken;      /* number of executions with errors */
    /* number of updates of rows that a slice did not name (redcc/parallel.h) */
    atomic_long misnamed;
    double largest;    /* largest difference, in ulps */
    const char *array; /* the array with this difference */
    char name[64];     /* storage for that array's name */
    redcc_int element; /* number of the element with this difference, counted from the array's first
                          element */
};

/** The saved contents of one array. */
struct held {
    char *memory; /* the contents before the loop, later the loop's results; NULL: nothing of the
                     array is written */
    char *place;  /* address of the saved bytes in the array */
    size_t bytes;
    bool in_order; /* the sequential loop's bits are promised, even for floating-point types */
};

/** The validation of one execution. If all fields are zero, there is none. */
struct validation {
    bool began;
    bool gave_up;       /* there was no memory, or an array is scattered */
    const char *method; /* the method that executed the loop */
    uint32_t count;
    struct held *held; /* [count] one for each array or, with a plan, for each group */
};

/** Bytes of an array that are about to be written. */
struct written {
    uint32_t array;
    struct range bytes;
    bool in_order; /* as in struct held */
};

/** Copies the contents of the plan's groups; the arrays begin at `bases`. There is no validation if
 * memory runs out or an array is scattered; the latter is counted in *validated. Called by one
 * thread, while no thread writes to the arrays. */
void redcc_validation_begin(struct validation *validation, const struct plan *plan,
                            void *const *bases, struct validated *validated);

/** As redcc_validation_begin, for executions without a plan. Called before the bytes `written` of
 * one of the loop's arrays are written. Copies those of these bytes that are not copied yet. */
void redcc_validation_grow(struct validation *validation, const redcc_loop *loop,
                           void *const *bases, struct written written, struct validated *validated);

/** Called after the loop: saves the loop's results, and restores the arrays' previous contents. */
void redcc_validation_swap(struct validation *validation);

/** Called when the loop was repeated: compares the arrays at `bases` with the saved results,
 * restores these results, records differences in *validated, and frees the memory. */
void redcc_validation_end(struct validation *validation, const redcc_loop *loop, void *const *bases,
                          struct validated *validated);

#endif
