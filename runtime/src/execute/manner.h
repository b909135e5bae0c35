/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * In which manner are iterations of a loop executed: with prefetches, by lanes, both or neither?
 * All give the same bits, so that parts of executions take turns, one in each manner
 * (learn/turns.h), and the best one is kept for a while. Long executions are cut: one of them does
 * for a trial. Where lanes are best, a second trial finds out whether half as many are better
 * still.
 */
#ifndef REDCC_EXECUTE_MANNER_H
#define REDCC_EXECUTE_MANNER_H

#include "learn/back_off.h"
#include "learn/turns.h"
#include "redcc/runtime.h"

/** A manner is a set of these; WITH_HALF, half as many lanes, only together with WITH_LANES. */
enum { WITH_PREFETCH = 1, WITH_LANES = 2, WITH_HALF = 4, MANNERS = 8 };

/** Rounds of a long execution, in which each manner of the trial has one part. */
enum { MANNER_ROUNDS = 2 * LEARN_PAIRS, MANNER_PARTS = MANNER_ROUNDS * TURN_ARMS };

/** What is known of a loop over its executions. All zero: nothing. */
struct manners {
    unsigned open;      /* what is being found out: each may be in a manner or not */
    unsigned settled;   /* by the first of two trials; 0: it is under way */
    struct turns turns; /* of the trial under way */
    unsigned best;      /* by the last trials */
    long executions;
    struct back_off rest; /* until the next trial, by their number */
};

/** Into how many parts an execution is cut, of which each thread executes so many iterations in the
 *  mean: what the trial lacks, or what the iterations allow; 0: there is no trial. `open` is what
 *  makes a difference to it. */
unsigned redcc_manner_parts(const struct manners *it, unsigned open, redcc_int iterations);

/** The manner of part number `part` of that execution: a subset of `open`. Part 0 of a loop that
 * was never executed has all of `open` but WITH_HALF. */
unsigned redcc_manner_of(const struct manners *it, unsigned open, unsigned part);

/** Notes an execution that is over: the seconds an iteration took in each part. One thread at a
 *  time. */
void redcc_manner_note(struct manners *it, unsigned open, unsigned parts, const double *seconds);

#endif
