/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Compares two alternatives (arms) when timings are noisy. The arms alternate, so that both run
 * under the same conditions. The shortest time of each arm counts, because an interruption is no
 * property of an arm.
 */
#ifndef REDCC_PAIRED_TIMING_H
#define REDCC_PAIRED_TIMING_H

enum { PAIRED_ARMS = 2 };

/** The timings of a comparison. If all fields are zero, nothing was timed. */
struct paired_timing {
    int timed;
    double least[PAIRED_ARMS]; /**< shortest time of each arm in seconds */
};

/** The arm to run after `timed` timings: arms 0 and 1 alternate. */
int redcc_arm_of(int timed);

/** Records the time of the current arm. */
void redcc_paired_note(struct paired_timing *it, double seconds);

/** The faster arm, or -1 while this is uncertain. It is certain after n rounds if the other arm
 * takes longer by at least the n-th part of LEARN_NOISE, or if n is the maximum number of rounds
 * (LEARN_PAIRS). */
int redcc_paired_winner(const struct paired_timing *it);

#endif
