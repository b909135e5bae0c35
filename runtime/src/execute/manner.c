/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/manner.h"

#include <assert.h>
#include <string.h>

/* Iterations of a part: less than 12 floating-point operations each are not timed, so that it takes
 * some microseconds at the least. */
enum { LEAST_PART = 512 };

/* Rounds of a trial that takes several executions. After two of them the better variant may be
 * evident: the other one has taken so many times as long, at the least. */
enum { SOME_ROUNDS = 4, EVIDENT_ROUNDS = 2, FIRST_REST = 64, LONGEST_REST = 4096 };
static const double evident = 1.7;

/* There and back: what changes slowly favours none. */
static bool tried_at(unsigned timed) {
    return timed / MANNERS % 2 == timed % MANNERS;
}

static bool is_trial(const struct manners *it, bool open) {
    return open && it->rest == 0;
}

unsigned redcc_manner_parts(const struct manners *it, bool open, redcc_int iterations) {
    if (!is_trial(it, open))
        return 0;
    const unsigned lacking = MANNER_PARTS - it->timed;
    const redcc_int possible = iterations / LEAST_PART;
    return possible < 1 ? 1 : possible < lacking ? (unsigned)possible : lacking;
}

bool redcc_manner_of(const struct manners *it, bool open, unsigned part) {
    return open && (is_trial(it, open) ? tried_at(it->timed + part) : it->best);
}

/* The shortest time of each variant in the rounds that go there, and in those that go back, added
 * up; [true]: with prefetches. */
static void least_of(const struct manners *it, double both[MANNERS]) {
    double least[2][MANNERS] = {{0}};
    for (unsigned part = 0; part < it->timed / MANNERS * MANNERS; part++) {
        double *of = &least[part / MANNERS % 2][tried_at(part)];
        if (*of <= 0 || it->seconds[part] < *of)
            *of = it->seconds[part];
    }
    for (unsigned manner = 0; manner < MANNERS; manner++)
        both[manner] = least[0][manner] + least[1][manner];
}

static void end_trial(struct manners *it, bool best) {
    it->timed = 0;
    it->best = best;
    it->interval = it->interval ? it->interval * 2 : FIRST_REST;
    it->interval = it->interval > LONGEST_REST ? LONGEST_REST : it->interval;
    it->rest = it->interval;
}

void redcc_manner_note(struct manners *it, bool open, unsigned parts, const double *seconds) {
    if (!open)
        return;
    if (!is_trial(it, open)) {
        it->rest--;
        return;
    }
    assert(it->timed + parts <= MANNER_PARTS);
    memcpy(it->seconds + it->timed, seconds, parts * sizeof *seconds);
    it->timed += parts;
    const unsigned rounds = it->timed / MANNERS;
    if (rounds < EVIDENT_ROUNDS)
        return;
    double both[MANNERS];
    least_of(it, both);
    const bool best = both[true] <= both[false];
    if (rounds >= SOME_ROUNDS || both[!best] >= evident * both[best])
        end_trial(it, best);
}
