/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Compares two alternatives (arms) under noise. They alternate, so that both run under the same
 * conditions. The shortest time of each arm counts, because an interruption is no property of an
 * arm.
 */
#ifndef REDCC_PAIRED_TIMING_H
#define REDCC_PAIRED_TIMING_H

enum { PAIRED_ARMS = 2 };

/** The timings of a comparison. If it is zero, nothing was timed. */
struct paired_timing {
    int timed;
    double least[PAIRED_ARMS]; /**< shortest time of each arm in seconds */
};

/** The arm to run after `timed` timings: arms 0 and 1 alternate. */
int redcc_arm_of(int timed);

/** Records the time of the current arm. */
void redcc_paired_note(struct paired_timing *it, double seconds);

/** The faster arm, if that is evident, otherwise -1. It is evident if after n rounds the other arm
 * takes longer by the n-th part of the noise, or if the maximum number of rounds is reached. */
int redcc_paired_winner(const struct paired_timing *it);

#endif
