/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Divides the iterations that a thread executes in one execution into timing slices, for a trial
 * that compares variants. */
#ifndef REDCC_EXECUTE_PARTS_H
#define REDCC_EXECUTE_PARTS_H

#include "execute/variant.h"

#include <stdbool.h>

/** One thread's timing slices. The code calls a slice a part. count == 0: there is no trial. */
struct parts {
    unsigned count;
    unsigned number; /* index of the current slice */
    redcc_int size;  /* number of iterations per slice; the last slice has all that remain */
    redcc_int left;  /* number of iterations left in the current slice */
    double began;    /* start of the current slice, in seconds */
    struct {
        double seconds;
        redcc_int iterations;
    } part[VARIANT_PARTS];
};

/** Begins slice 0 of `count` slices (at most VARIANT_PARTS). `iterations` is the total number of
 * iterations of the thread. */
void redcc_parts_begin(struct parts *it, unsigned count, redcc_int iterations);

/** If the current slice has no iterations left, ends it, begins the next one, and returns true. */
bool redcc_parts_next(struct parts *it);

/** Ends the current slice, if any. */
void redcc_parts_end(struct parts *it);

/** Adds the thread's seconds and iterations in slice i to seconds[i] and iterations[i], for each i
 * below it->count. */
void redcc_parts_add(const struct parts *it, double *seconds, double *iterations);

#endif
