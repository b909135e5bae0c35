/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "learn/turns.h"

#include "learn/constants.h"

#include <assert.h>
#include <stdbool.h>

static bool is_back(int arms, int timed) {
    return arms > 2 && timed / arms % 2;
}

int redcc_turn_of(int arms, int timed) {
    return is_back(arms, timed) ? arms - 1 - timed % arms : timed % arms;
}

void redcc_turns_note(struct turns *it, double seconds) {
    const int arm = redcc_turn_of(it->arms, it->timed);
    assert(arm < TURN_ARMS);
    double *least = &it->least[is_back(it->arms, it->timed)][arm];
    *least = *least <= 0 || seconds < *least ? seconds : *least;
    it->sum[arm] += seconds;
    it->count[arm]++;
    it->timed++;
}

int redcc_turns_winner(const struct turns *it) {
    const bool returns = it->arms > 2;
    const int rounds = it->timed / it->arms, each = returns ? rounds / 2 : rounds;
    int best = 0;
    double least = 0, next = 0;
    for (int arm = 0; arm < it->arms; arm++) {
        const double seconds = it->least[0][arm] + it->least[1][arm];
        const bool is_best = arm == 0 || seconds < least;
        if (is_best ? arm > 0 : next <= 0 || seconds < next)
            next = is_best ? least : seconds;
        least = is_best ? seconds : least;
        best = is_best ? arm : best;
    }
    const double noise = returns ? 2 * LEARN_NOISE : LEARN_NOISE;
    const bool is_evident = each > 0 && next > (1 + noise / each) * least;
    return is_evident || each >= (returns ? 2 : LEARN_PAIRS) ? best : -1;
}

double redcc_turns_mean(const struct turns *it, int arm) {
    return it->sum[arm] / it->count[arm];
}
