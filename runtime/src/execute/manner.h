/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * In which manner are executions of a loop made: with prefetches, by lanes, both or neither? All
 * give the same bits, so that the first executions are timed in each manner in turn, and the best
 * one is kept for a while.
 */
#ifndef REDCC_EXECUTE_MANNER_H
#define REDCC_EXECUTE_MANNER_H

/** A manner is a set of these. */
enum { WITH_PREFETCH = 1, WITH_LANES = 2, MANNERS = 4 };

/** What is known of a loop over its executions. All zero: nothing. */
struct manners {
    unsigned open;         /* what is being found out: each may be in a manner or not */
    unsigned idle;         /* what made no difference to the last execution */
    unsigned timed;        /* executions of the trial under way */
    double least[MANNERS]; /* seconds an iteration, of the trial; 0: none yet */
    unsigned best;         /* by the last trial */
    unsigned rest;         /* executions until the next trial */
    unsigned interval;     /* between the last two trials */
};

/** The manner of the execution that begins, a part of `open`; all of it at first. One thread at a
 *  time. */
unsigned redcc_manner_begins(struct manners *it, unsigned open);

/** An execution is over in a manner that redcc_manner_begins gave for `open`; of that only
 *  `of_use` made a difference. One thread at a time. */
void redcc_manner_note(struct manners *it, unsigned open, unsigned of_use, unsigned manner,
                       double seconds_an_iteration);

#endif
