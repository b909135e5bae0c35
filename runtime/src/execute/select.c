/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/select.h"

#include <assert.h>

enum { SKIPPED = -1, PLAIN = 0, CHECKED = 1 };

void redcc_selection_begin(struct selection *selection, redcc_worker *worker, redcc_int trip) {
    assert(trip >= 0);
    selection->trip = trip;
    selection->idle_begin = selection->idle_end = 0;
    selection->executed = 0;
    selection->taken = 0;
    selection->asked = false;
    worker->first = worker->last = 0;
    worker->window = selection->window;
}

void redcc_selection_set_idle(struct selection *selection, redcc_int begin, redcc_int end) {
    assert(0 <= begin && begin <= end && end <= selection->trip);
    selection->idle_begin = begin;
    selection->idle_end = end;
}

bool redcc_selection_ask(struct selection *selection, redcc_worker *worker) {
    const redcc_int left = selection->trip - worker->last;
    assert(!selection->asked && left >= 0);
    if (left == 0)
        return false;
    worker->first = worker->last;
    worker->last += left < REDCC_SELECTED ? left : REDCC_SELECTED;
    worker->stride = 1;
    worker->entry = (redcc_entry *)(void *)selection->class;
    selection->asked = true;
    return true;
}

static int part_of(const struct selection *selection, redcc_int iteration, bool hooked) {
    const unsigned class = selection->class[iteration] & ~(unsigned)REDCC_CLASS_LEADS;
    switch (class) {
    case REDCC_CLASS_OWN:
        return hooked ? CHECKED : PLAIN;
    case REDCC_CLASS_OWN | REDCC_CLASS_OTHERS:
        return CHECKED;
    default:
        return SKIPPED;
    }
}

/* Does another thread store the operands that the iteration adds to series? No for an iteration
 * that touches nothing, which only one thread executes. */
static bool follows(const struct selection *selection, redcc_int iteration) {
    const unsigned class = selection->class[iteration];
    return class != 0 && !(class & REDCC_CLASS_LEADS);
}

size_t redcc_selection_take(struct selection *selection, const redcc_worker *worker, bool hooked,
                            redcc_iterations *to, redcc_int *iterations) {
    const redcc_int count = worker->last - worker->first;
    size_t runs = 0;
    int last = SKIPPED;
    assert(0 < count && count <= REDCC_SELECTED);
    if (selection->asked)
        selection->taken = 0;
    selection->asked = false;
    *iterations = 0;
    for (; selection->taken < count; selection->taken++) {
        const redcc_int i = selection->taken;
        int part = part_of(selection, i, hooked);
        if (selection->class[i] == 0 && worker->first + i >= selection->idle_begin &&
            worker->first + i < selection->idle_end)
            part = hooked ? CHECKED : PLAIN;
        if (part != SKIPPED && runs > 0 && selection->follows != follows(selection, i))
            break;
        if (part != SKIPPED)
            selection->follows = follows(selection, i);
        if (part != SKIPPED && part == last)
            to[runs - 1].count_and_check += 2;
        else if (part != SKIPPED)
            to[runs++] = (redcc_iterations){(redcc_u32)i, 2 + (redcc_u32)part};
        *iterations += part != SKIPPED;
        last = part;
    }
    selection->executed += *iterations;
    return runs;
}
