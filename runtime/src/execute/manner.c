/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/manner.h"

#include <stdbool.h>

/* Each manner so often, there and back: what changes slowly favours none. */
enum { ROUNDS = 3, FIRST_REST = 64, LONGEST_REST = 4096 };
/* After two rounds all others have taken so many times as long, at the least: no third is needed.
 */
enum { EVIDENT_ROUNDS = 2 };
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

static unsigned tried_at(unsigned open, unsigned timed) {
    const unsigned count = count_of(open), number = timed % count;
    return manner_of(open, timed / count % 2 ? count - 1 - number : number);
}

unsigned redcc_manner_begins(struct manners *it, unsigned open) {
    open &= ~it->idle;
    if (open != it->open) {
        *it = (struct manners){.open = open, .idle = it->idle};
    }
    return it->rest > 0 ? it->best : tried_at(open, it->timed);
}

static unsigned best_of(const struct manners *it) {
    unsigned best = it->open;
    for (unsigned number = 1; number < count_of(it->open); number++) {
        const unsigned manner = manner_of(it->open, number);
        if (it->least[manner] < it->least[best])
            best = manner;
    }
    return best;
}

static bool is_evident(const struct manners *it) {
    const unsigned best = best_of(it);
    for (unsigned number = 0; number < count_of(it->open); number++) {
        const unsigned manner = manner_of(it->open, number);
        if (manner != best && it->least[manner] < evident * it->least[best])
            return false;
    }
    return true;
}

static void end_trial(struct manners *it) {
    it->best = best_of(it);
    it->interval = it->interval ? it->interval * 2 : FIRST_REST;
    it->interval = it->interval > LONGEST_REST ? LONGEST_REST : it->interval;
    it->rest = it->interval;
    it->timed = 0;
    for (unsigned manner = 0; manner < MANNERS; manner++)
        it->least[manner] = 0;
}

void redcc_manner_note(struct manners *it, unsigned open, unsigned of_use, unsigned manner,
                       double seconds_an_iteration) {
    it->idle = open & ~of_use;
    if ((open & of_use) != it->open || it->open == 0)
        return; /* the next one begins anew */
    if (it->rest > 0) {
        it->rest--;
        return;
    }
    double *least = &it->least[manner];
    *least = *least > 0 && *least < seconds_an_iteration ? *least : seconds_an_iteration;
    it->timed++;
    if (it->timed == ROUNDS * count_of(it->open) ||
        (it->timed == EVIDENT_ROUNDS * count_of(it->open) && is_evident(it)))
        end_trial(it);
}
