/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The paired comparison under noise: two arms alternate, so that both run under the same
 * conditions. The shortest time of each counts, because an interruption is no property of an arm.
 */
#ifndef REDCC_LEARN_TURNS_H
#define REDCC_LEARN_TURNS_H

enum { TURN_ARMS = 2 };

/** Zero: nothing was timed. */
struct turns {
    int timed;
    double least[TURN_ARMS]; /**< seconds */
};

/** The arm to run after `timed` timings: 0 1 0 1 */
int redcc_turn_of(int timed);

/** Records the time of the current arm. */
void redcc_turns_note(struct turns *it, double seconds);

/** The faster arm, if that is evident: after n rounds the other one takes longer by the n-th part
 *  of the noise, or the maximum number of rounds is reached. Else -1. */
int redcc_turns_winner(const struct turns *it);

#endif
