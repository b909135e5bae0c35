/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A thread's iterations of one execution, divided into timing slices for a trial of variants. */
#ifndef REDCC_EXECUTE_PARTS_H
#define REDCC_EXECUTE_PARTS_H

#include "execute/variant.h"

#include <stdbool.h>

/** One thread's timing slices, which are called parts. count == 0: no trial. */
struct parts {
    unsigned count;
    unsigned number; /* index of the current slice */
    redcc_int size;  /* iterations per slice; the last one has all that remain */
    redcc_int left;  /* iterations left in the current slice */
    double began;    /* s, start of the current slice */
    struct {
        double seconds;
        redcc_int iterations;
    } part[VARIANT_PARTS];
};

/** Begins slice 0 of `count` (at most VARIANT_PARTS); iterations: the total number. */
void redcc_parts_begin(struct parts *it, unsigned count, redcc_int iterations);

/** If the current slice has no iterations left, ends it and begins the next one. Returns whether it
 *  did. */
bool redcc_parts_next(struct parts *it);

/** Ends the current slice, if any. */
void redcc_parts_end(struct parts *it);

/** Adds the thread's times to seconds[] and iterations[] [it->count]. */
void redcc_parts_add(const struct parts *it, double *seconds, double *iterations);

#endif
