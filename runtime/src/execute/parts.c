/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/parts.h"

#include "base/clock.h"

#include <assert.h>
#include <limits.h>

/* The number of iterations of the current timing slice. The last slice has all remaining
 * iterations, including stolen ones. */
static redcc_int slice_size(const struct parts *it) {
    return it->number + 1 == it->count ? LLONG_MAX : it->size;
}

static void begin_part(struct parts *it, unsigned number) {
    it->number = number;
    it->left = slice_size(it);
    it->began = redcc_seconds();
}

void redcc_parts_begin(struct parts *it, unsigned count, redcc_int iterations) {
    assert(count <= VARIANT_PARTS && iterations >= 0);
    it->count = count;
    if (count == 0)
        return;
    for (unsigned number = 0; number < count; number++)
        it->part[number].iterations = 0;
    it->size = iterations / count + 1;
    begin_part(it, 0);
}

bool redcc_parts_next(struct parts *it) {
    assert(it->left >= 0);
    if (it->left > 0)
        return false;
    redcc_parts_end(it);
    begin_part(it, it->number + 1);
    return true;
}

void redcc_parts_end(struct parts *it) {
    if (it->count == 0)
        return;
    assert(it->number < it->count);
    it->part[it->number].seconds = redcc_seconds() - it->began;
    it->part[it->number].iterations = slice_size(it) - it->left;
}

void redcc_parts_add(const struct parts *it, double *seconds, double *iterations) {
    assert(it->count <= VARIANT_PARTS);
    for (unsigned number = 0; number < it->count; number++) {
        if (it->part[number].iterations == 0)
            continue;
        seconds[number] += it->part[number].seconds;
        iterations[number] += (double)it->part[number].iterations;
    }
}
