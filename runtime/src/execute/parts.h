/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A thread's iterations of one execution, cut into parts that are timed, for a trial of manners.
 */
#ifndef REDCC_EXECUTE_PARTS_H
#define REDCC_EXECUTE_PARTS_H

#include "execute/manner.h"

#include <stdbool.h>

/** One thread's. With a count of 0 nothing is cut. */
struct parts {
    unsigned count;
    unsigned number; /* of the part under way */
    redcc_int size;  /* iterations of each; the last one has all that remain */
    redcc_int left;  /* of the part under way */
    double began;
    struct {
        double seconds;
        redcc_int iterations;
    } part[MANNER_PARTS];
};

/** Begins part 0 of `count`, now; of no more than MANNER_PARTS, of so many iterations in all. */
void redcc_parts_begin(struct parts *it, unsigned count, redcc_int iterations);

/** Where no iteration is left of the part under way, ends it and begins the next one. Returns
 *  whether it did. */
bool redcc_parts_turn(struct parts *it);

/** Ends the part under way, where there is one. */
void redcc_parts_end(struct parts *it);

/** Adds to seconds[] and iterations[] [it->count] what the thread took for its parts. */
void redcc_parts_add(const struct parts *it, double *seconds, double *iterations);

#endif
