/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Chooses between executing a loop with prefetches or without. Both give the same bits, so timing
 * slices of executions alternate (learn/turns.h), and the faster variant is kept for a while. A
 * long execution is sliced, and suffices for a trial.
 */
#ifndef REDCC_EXECUTE_VARIANT_H
#define REDCC_EXECUTE_VARIANT_H

#include "learn/back_off.h"
#include "learn/turns.h"
#include "redcc/runtime.h"

#include <stdbool.h>

/** Rounds of a long execution, in which each variant has one slice. */
enum {
    VARIANTS = TURN_ARMS,
    VARIANT_ROUNDS = 2 * LEARN_PAIRS,
    VARIANT_PARTS = VARIANT_ROUNDS * VARIANTS
};

/** Results over a loop's executions. Initially zero. */
struct variants {
    struct turns turns;   /* of the current trial */
    bool best;            /* with prefetches, according to the last trial */
    long executions;      /* long enough for a difference */
    struct back_off rest; /* executions until the next trial */
};

/** The number of timing slices of an execution in which each thread executes `iterations` on
 *  average: as many as the trial still needs, or as the iterations permit; 0: no trial. `open`: the
 *  variants are to be compared. */
unsigned redcc_variant_parts(const struct variants *it, bool open, redcc_int iterations);

/** Does slice number `part` of that execution prefetch? Slice 0 of a loop that was never executed
 *  does, if the choice is open. */
bool redcc_variant_of(const struct variants *it, bool open, unsigned part);

/** Records a finished execution: the seconds per iteration of each slice. One thread at a time. */
void redcc_variant_note(struct variants *it, bool open, unsigned parts, const double *seconds);

#endif
