/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/share_count.h"

#include "base/share.h"

#include <stddef.h>

enum {
    /* Shorter loops are not worth a call of the runtime. */
    LEAST_ITERATIONS = 8192,
    /* As LEAST_ITERATIONS, for loops whose iterations have inner loops or calls. It applies if a
     * copy has at most one element for HEAVY updates. */
    LEAST_HEAVY = 512,
    /* More than two shares are used only if there are this many updates per element of all copies
     * together. Merging an element into the array and clearing it takes a third of an update's
     * time. Two shares need only one update per element, because they halve the time. More shares
     * gain nothing on two cores, so their merge must be cheap (script/bench openmp). */
    ITERATIONS_PER_ELEMENT = 24,
    /* Number of updates that an iteration with inner loops or calls counts as. */
    HEAVY = 8,
    /* The same for iterations with REDCC_LONG. */
    LONG = 512
};

/* Maximum size of all copies in bytes. It is several times the size of the last-level cache of a
 * few cores. */
static const size_t most_bytes = (size_t)64 << 20;

double redcc_updates(const redcc_loop *loop, redcc_int trip) {
    return (double)trip * (loop->flags & REDCC_SHORT ? 1 : loop->flags & REDCC_LONG ? LONG : HEAVY);
}

int redcc_share_count(const redcc_loop *loop, redcc_int trip, double updates, redcc_size bytes,
                      redcc_size memory_limit) {
    if (trip < (loop->flags & REDCC_SHORT ? LEAST_ITERATIONS : LEAST_HEAVY))
        return 0;
    const size_t most =
        memory_limit && memory_limit / 4 < most_bytes ? memory_limit / 4 : most_bytes;
    const double elements = (double)bytes / sizeof(double);
    if (trip < LEAST_ITERATIONS && elements > updates / (double)HEAVY)
        return 0;
    if (elements > updates || bytes > most)
        return 1;
    int shares = REDCC_MOST_SHARES;
    while (shares > 2 &&
           ((double)(shares - 1) * elements * (double)ITERATIONS_PER_ELEMENT > updates ||
            bytes > most / (size_t)(shares - 1)))
        shares /= 2;
    return shares;
}

redcc_int redcc_share_begin(redcc_int trip, int shares, int share) {
    const redcc_int blocks = (trip - 1) / REDCC_SUM_BLOCK + 1;
    const redcc_int begin = redcc_share(blocks, shares, share) * REDCC_SUM_BLOCK;
    return begin < trip ? begin : trip;
}
