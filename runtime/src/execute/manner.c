/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/manner.h"

#include <assert.h>
#include <stdbool.h>

/* Iterations of a part: less than 12 floating-point operations each are not timed, so that it takes
 * some microseconds at the least. */
enum { LEAST_PART = 512 };

/* What one trial finds out: which of `open` to have beside what is settled. */
struct question {
    unsigned open, settled;
    int timed; /* parts before this execution */
};

static struct question question_of(const struct manners *it, unsigned open) {
    const unsigned first = open & ~(unsigned)WITH_HALF;
    if (it->open != open)
        return (struct question){first, 0, 0};
    return (struct question){it->settled ? WITH_HALF : first, it->settled, it->turns.timed};
}

static int arms_of(const struct question *q) {
    return 1 << __builtin_popcount(q->open);
}

/* Number 0 has all that is open, the last one nothing. */
static unsigned manner_of(const struct question *q, int number) {
    unsigned manner = q->open;
    for (; number > 0; number--)
        manner = (manner - 1) & q->open;
    return q->settled | manner;
}

static bool is_trial(const struct manners *it, unsigned open) {
    return open != 0 && (it->open != open || it->executions >= it->rest.until);
}

unsigned redcc_manner_parts(const struct manners *it, unsigned open, redcc_int iterations) {
    if (!is_trial(it, open))
        return 0;
    const struct question q = question_of(it, open);
    const int lacking = MANNER_ROUNDS * arms_of(&q) - q.timed;
    const redcc_int possible = iterations / LEAST_PART;
    return possible < 1 ? 1 : possible < lacking ? (unsigned)possible : (unsigned)lacking;
}

unsigned redcc_manner_of(const struct manners *it, unsigned open, unsigned part) {
    const struct question q = question_of(it, open);
    return is_trial(it, open) ? manner_of(&q, redcc_turn_of(arms_of(&q), q.timed + (int)part))
                              : it->best & open;
}

/* A trial takes the whole of an execution: the next one waits for four times as many. */
static void end_trial(struct manners *it, unsigned best) {
    it->turns.timed = 0;
    if (it->open & WITH_HALF && best & WITH_LANES && !it->settled) {
        it->settled = best;
        return;
    }
    it->settled = 0;
    it->best = best;
    it->rest.length = redcc_longer(it->rest.length);
    it->rest.until = it->executions + 4 * it->rest.length;
}

void redcc_manner_note(struct manners *it, unsigned open, unsigned parts, const double *seconds) {
    if (open == 0)
        return;
    const struct question q = question_of(it, open);
    const bool tries = is_trial(it, open);
    if (it->open != open)
        *it = (struct manners){.open = open};
    it->executions++;
    if (!tries)
        return;
    if (q.timed == 0)
        it->turns = (struct turns){.arms = arms_of(&q)};
    assert(it->turns.timed + (int)parts <= MANNER_PARTS);
    for (unsigned part = 0; part < parts; part++)
        redcc_turns_note(&it->turns, seconds[part]);
    const bool is_enough = it->turns.timed >= 2 * it->turns.arms;
    const int best = is_enough ? redcc_turns_winner(&it->turns) : -1;
    if (best >= 0)
        end_trial(it, manner_of(&q, best));
}
