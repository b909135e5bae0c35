/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The paired comparison under noise: two arms alternate, so that both run under the same
 * conditions. The shortest time of each counts, because an interruption is no property of an arm.
 */
#ifndef REDCC_PAIRED_TIMING_H
#define REDCC_PAIRED_TIMING_H

enum { PAIRED_ARMS = 2 };

/** Zero: nothing was timed. */
struct paired_timing {
    int timed;
    double least[PAIRED_ARMS]; /**< seconds */
};

/** The arm to run after `timed` timings: 0, 1, 0, 1, ... */
int redcc_arm_of(int timed);

/** Records the time of the current arm. */
void redcc_paired_note(struct paired_timing *it, double seconds);

/** The faster arm, if that is evident: after n rounds the other one takes longer by the n-th part
 *  of the noise, or the maximum number of rounds is reached. Else -1. */
int redcc_paired_winner(const struct paired_timing *it);

#endif
