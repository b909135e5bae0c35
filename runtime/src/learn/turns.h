/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The paired comparison under noise: arms take turns, there and back, so that all meet the machine
 * as it is now and what changes slowly favours none. Of the rounds that go one way the shortest
 * time of each arm counts: an interruption is no property of an arm.
 */
#ifndef REDCC_LEARN_TURNS_H
#define REDCC_LEARN_TURNS_H

enum { TURN_ARMS = 4 /* at most */ };

/** All zero but for `arms`: nothing was timed. */
struct turns {
    int arms;
    int timed;
    double least[2][TURN_ARMS]; /**< seconds: in the rounds there, and back */
    double sum[TURN_ARMS];
    int count[TURN_ARMS];
};

/** Whose turn it is after so many: 0 1 0 1; 0 1 2 3, 3 2 1 0 */
int redcc_turn_of(int arms, int timed);

/** Notes what the arm whose turn it was took. */
void redcc_turns_note(struct turns *it, double seconds);

/** The fastest arm, where that is evident: after n rounds the next one takes longer by the n-th
 * part of the noise, or there have been enough of them. Else -1. */
int redcc_turns_winner(const struct turns *it);

/** Mean seconds of an arm that was timed. */
double redcc_turns_mean(const struct turns *it, int arm);

#endif
