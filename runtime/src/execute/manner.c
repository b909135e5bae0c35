/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/manner.h"

#include <assert.h>
#include <stdbool.h>
#include <string.h>

/* Iterations of a part: less than 12 floating-point operations each are not timed, so that it takes
 * some microseconds at the least. */
enum { LEAST_PART = 512 };

/* Rounds of a trial that takes several executions. After two of them the best manner may be
 * evident: all others have taken so many times as long, at the least. */
enum { SOME_ROUNDS = 4, EVIDENT_ROUNDS = 2, FIRST_REST = 64, LONGEST_REST = 4096 };
static const double evident = 1.7;

static unsigned count_of(unsigned open) {
    return open == 0 ? 1 : open == (WITH_PREFETCH | WITH_LANES) ? 4 : 2;
}

/* Number 0 has all that is open, the last one nothing. */
static unsigned manner_of(unsigned open, unsigned number) {
    unsigned manner = open;
    for (; number > 0; number--)
        manner = (manner - 1) & open;
    return manner;
}

/* There and back: what changes slowly favours none. */
static unsigned tried_at(unsigned open, unsigned timed) {
    const unsigned count = count_of(open), number = timed % count;
    return manner_of(open, timed / count % 2 ? count - 1 - number : number);
}

static bool is_trial(const struct manners *it, unsigned open) {
    return open != 0 && (it->open != open || it->rest == 0);
}

static unsigned timed_before(const struct manners *it, unsigned open) {
    return it->open == open ? it->timed : 0;
}

unsigned redcc_manner_parts(const struct manners *it, unsigned open, redcc_int iterations) {
    if (!is_trial(it, open))
        return 0;
    const unsigned lacking = MANNER_ROUNDS * count_of(open) - timed_before(it, open);
    const redcc_int possible = iterations / LEAST_PART;
    return possible < 1 ? 1 : possible < lacking ? (unsigned)possible : lacking;
}

unsigned redcc_manner_of(const struct manners *it, unsigned open, unsigned part) {
    return is_trial(it, open) ? tried_at(open, timed_before(it, open) + part) : it->best & open;
}

/* The shortest time of each manner in the rounds that go there, and in those that go back. */
static void least_of(const struct manners *it, double least[2][MANNERS]) {
    const unsigned count = count_of(it->open);
    memset(least, 0, 2 * sizeof *least);
    for (unsigned part = 0; part < it->timed / count * count; part++) {
        double *of = &least[part / count % 2][tried_at(it->open, part)];
        if (*of <= 0 || it->seconds[part] < *of)
            *of = it->seconds[part];
    }
}

/* The fastest manner, of at least two rounds; *lead: how many times as long the next one takes. */
static unsigned best_of(const struct manners *it, double *lead) {
    double least[2][MANNERS], both[MANNERS], next = 0;
    unsigned best = it->open;
    least_of(it, least);
    for (unsigned manner = 0; manner < MANNERS; manner++)
        both[manner] = least[0][manner] + least[1][manner];
    for (unsigned number = 1; number < count_of(it->open); number++) {
        const unsigned manner = manner_of(it->open, number);
        const unsigned other = both[manner] < both[best] ? best : manner;
        best = other == best ? manner : best;
        next = next <= 0 || both[other] < next ? both[other] : next;
    }
    *lead = next / both[best];
    return best;
}

static void end_trial(struct manners *it, unsigned best) {
    it->best = best;
    it->interval = it->interval ? it->interval * 2 : FIRST_REST;
    it->interval = it->interval > LONGEST_REST ? LONGEST_REST : it->interval;
    it->rest = it->interval;
    it->timed = 0;
}

void redcc_manner_note(struct manners *it, unsigned open, unsigned parts, const double *seconds) {
    if (open == 0)
        return;
    if (!is_trial(it, open)) {
        it->rest--;
        return;
    }
    if (it->open != open)
        *it = (struct manners){.open = open};
    assert(it->timed + parts <= MANNER_PARTS);
    memcpy(it->seconds + it->timed, seconds, parts * sizeof *seconds);
    it->timed += parts;
    const unsigned rounds = it->timed / count_of(open);
    if (rounds < EVIDENT_ROUNDS)
        return;
    double lead;
    const unsigned best = best_of(it, &lead);
    if (rounds >= SOME_ROUNDS || lead >= evident)
        end_trial(it, best);
}
