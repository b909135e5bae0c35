/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/within.h"

#include "base/escapes.h"
#include "base/signals.h"
#include "base/team.h"

void redcc_within_begin(struct within *within, bool always, int threads) {
    within->was_within = redcc_within;
    redcc_within = 1;
    within->holds_signals = always || redcc_team_grows(threads) || redcc_may_escape();
    if (within->holds_signals)
        within->signals = redcc_signals_hold();
}

void redcc_within_relax(struct within *within, bool always, bool is_long) {
    if (!within->holds_signals)
        return;
    if (!always && !redcc_may_escape()) {
        within->holds_signals = false;
        redcc_signals_release(within->signals);
    } else if (is_long) {
        redcc_signals_let_default(within->signals);
    }
}

void redcc_within_end(struct within within) {
    redcc_within = within.was_within;
    if (within.holds_signals)
        redcc_signals_release(within.signals);
}
