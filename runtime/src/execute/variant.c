/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/variant.h"

#include <assert.h>

/* The smallest number of iterations of a timing slice. A slice then takes at least some
 * microseconds. */
enum { LEAST_PART = 512 };

/* The smallest number of rounds after which a trial may be decided. One round would not do, because
 * the first slice of an execution finds cold caches. */
enum { LEAST_ROUNDS = 2 };

static bool is_trial(const struct variants *it, bool open) {
    return open && it->executions >= it->back_off.until;
}

unsigned redcc_variant_parts(const struct variants *it, bool open, redcc_int iterations) {
    assert(iterations >= 0);
    if (!is_trial(it, open))
        return 0;
    const int lacking = VARIANT_PARTS - it->pairs.timed;
    assert(lacking > 0); /* otherwise the trial would have ended */
    const redcc_int possible = iterations / LEAST_PART;
    return possible < 1 ? 1 : possible < lacking ? (unsigned)possible : (unsigned)lacking;
}

bool redcc_variant_of(const struct variants *it, bool open, unsigned part) {
    return open && (is_trial(it, open) ? redcc_arm_of(it->pairs.timed + (int)part) == 0 : it->best);
}

/* Ends a trial and stores the better variant. The next trial begins after four times the length of
 * the back-off. This length doubles with each trial, up to a limit. */
static void end_trial(struct variants *it, bool best) {
    it->pairs = (struct paired_timing){0};
    it->best = best;
    it->back_off.length = redcc_longer(it->back_off.length);
    it->back_off.until = it->executions + 4 * it->back_off.length;
}

void redcc_variant_note(struct variants *it, bool open, unsigned parts, const double *seconds) {
    if (!open)
        return;
    const bool tries = is_trial(it, open);
    it->executions++;
    if (!tries)
        return;
    assert(it->pairs.timed + (int)parts <= VARIANT_PARTS);
    for (unsigned part = 0; part < parts; part++)
        redcc_paired_note(&it->pairs, seconds[part]);
    const bool is_enough = it->pairs.timed >= LEAST_ROUNDS * VARIANTS;
    const int best = is_enough ? redcc_paired_winner(&it->pairs) : -1;
    if (best >= 0)
        end_trial(it, best == 0);
}
