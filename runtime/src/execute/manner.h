/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Are iterations of a loop executed with prefetches or without? Both give the same bits, so that
 * parts of executions take turns (learn/turns.h), and the faster variant is kept for a while. Long
 * executions are cut: one of them does for a trial.
 */
#ifndef REDCC_EXECUTE_MANNER_H
#define REDCC_EXECUTE_MANNER_H

#include "learn/back_off.h"
#include "learn/turns.h"
#include "redcc/runtime.h"

#include <stdbool.h>

/** Rounds of a long execution, in which each variant has one part. */
enum {
    MANNERS = TURN_ARMS,
    MANNER_ROUNDS = 2 * LEARN_PAIRS,
    MANNER_PARTS = MANNER_ROUNDS * MANNERS
};

/** What is known of a loop over its executions. All zero: nothing. */
struct manners {
    struct turns turns;   /* of the trial under way */
    bool best;            /* with prefetches, by the last trial */
    long executions;      /* in which they may make a difference */
    struct back_off rest; /* until the next trial, by their number */
};

/** Into how many parts an execution is cut, of which each thread executes so many iterations in the
 *  mean: what the trial lacks, or what the iterations allow; 0: there is no trial. `open`: it is to
 *  be found out. */
unsigned redcc_manner_parts(const struct manners *it, bool open, redcc_int iterations);

/** Does part number `part` of that execution prefetch? Part 0 of a loop that was never executed
 *  does, where that is open. */
bool redcc_manner_of(const struct manners *it, bool open, unsigned part);

/** Notes an execution that is over: the seconds an iteration took in each part. One thread at a
 *  time. */
void redcc_manner_note(struct manners *it, bool open, unsigned parts, const double *seconds);

#endif
