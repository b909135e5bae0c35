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

/* What one trial finds out: which of `open` to have beside what is settled. */
struct question {
    unsigned open, settled;
    unsigned timed; /* parts before this execution */
};

static struct question question_of(const struct manners *it, unsigned open) {
    if (it->open != open)
        return (struct question){open & ~(unsigned)WITH_HALF, 0, 0};
    return (struct question){it->settled ? WITH_HALF : open & ~(unsigned)WITH_HALF, it->settled,
                             it->timed};
}

static unsigned count_of(const struct question *q) {
    return q->open == 0 ? 1 : q->open == (WITH_PREFETCH | WITH_LANES) ? 4 : 2;
}

/* Number 0 has all that is open, the last one nothing. */
static unsigned manner_of(const struct question *q, unsigned number) {
    unsigned manner = q->open;
    for (; number > 0; number--)
        manner = (manner - 1) & q->open;
    return q->settled | manner;
}

/* There and back: what changes slowly favours none. */
static unsigned tried_at(const struct question *q, unsigned timed) {
    const unsigned count = count_of(q), number = timed % count;
    return manner_of(q, timed / count % 2 ? count - 1 - number : number);
}

static bool is_trial(const struct manners *it, unsigned open) {
    return open != 0 && (it->open != open || it->rest == 0);
}

unsigned redcc_manner_parts(const struct manners *it, unsigned open, redcc_int iterations) {
    if (!is_trial(it, open))
        return 0;
    const struct question q = question_of(it, open);
    const unsigned lacking = MANNER_ROUNDS * count_of(&q) - q.timed;
    const redcc_int possible = iterations / LEAST_PART;
    return possible < 1 ? 1 : possible < lacking ? (unsigned)possible : lacking;
}

unsigned redcc_manner_of(const struct manners *it, unsigned open, unsigned part) {
    const struct question q = question_of(it, open);
    return is_trial(it, open) ? tried_at(&q, q.timed + part) : it->best & open;
}

/* The shortest time of each manner in the rounds that go there, and in those that go back. */
static void least_of(const struct manners *it, const struct question *q, double least[2][MANNERS]) {
    const unsigned count = count_of(q);
    memset(least, 0, 2 * sizeof *least);
    for (unsigned part = 0; part < it->timed / count * count; part++) {
        double *of = &least[part / count % 2][tried_at(q, part)];
        if (*of <= 0 || it->seconds[part] < *of)
            *of = it->seconds[part];
    }
}

/* The fastest manner, of at least two rounds; *lead: how many times as long the next one takes. */
static unsigned best_of(const struct manners *it, const struct question *q, double *lead) {
    double least[2][MANNERS], both[MANNERS], next = 0;
    unsigned best = manner_of(q, 0);
    least_of(it, q, least);
    for (unsigned manner = 0; manner < MANNERS; manner++)
        both[manner] = least[0][manner] + least[1][manner];
    for (unsigned number = 1; number < count_of(q); number++) {
        const unsigned manner = manner_of(q, number);
        const unsigned other = both[manner] < both[best] ? best : manner;
        best = other == best ? manner : best;
        next = next <= 0 || both[other] < next ? both[other] : next;
    }
    *lead = next / both[best];
    return best;
}

static void end_trial(struct manners *it, unsigned best) {
    it->timed = 0;
    if (it->open & WITH_HALF && best & WITH_LANES && !it->settled) {
        it->settled = best;
        return;
    }
    it->settled = 0;
    it->best = best;
    it->interval = it->interval ? it->interval * 2 : FIRST_REST;
    it->interval = it->interval > LONGEST_REST ? LONGEST_REST : it->interval;
    it->rest = it->interval;
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
    const struct question q = question_of(it, open);
    const unsigned rounds = it->timed / count_of(&q);
    if (rounds < EVIDENT_ROUNDS)
        return;
    double lead;
    const unsigned best = best_of(it, &q, &lead);
    if (rounds >= SOME_ROUNDS || lead >= evident)
        end_trial(it, best);
}
