/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "learn/paired_timing.h"

#include "learn/constants.h"

#include <assert.h>
#include <stdbool.h>

int redcc_arm_of(int timed) {
    assert(timed >= 0);
    return timed % PAIRED_ARMS;
}

void redcc_paired_note(struct paired_timing *it, double seconds) {
    const int arm = redcc_arm_of(it->timed);
    if (it->least[arm] <= 0 || seconds < it->least[arm])
        it->least[arm] = seconds;
    it->timed++;
}

int redcc_paired_winner(const struct paired_timing *it) {
    const int rounds = it->timed / PAIRED_ARMS;
    const int best = it->least[1] < it->least[0];
    const bool is_evident =
        rounds > 0 && it->least[!best] > (1 + LEARN_NOISE / rounds) * it->least[best];
    return is_evident || rounds >= LEARN_PAIRS ? best : -1;
}
