/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Sums over chunks of consecutive items. A chunk's length depends only on the number of items, so
 *  a sum has the same bits at any number of threads. The caller's loop over chunks fills
 *  sum[CHUNK_SUM_MOST]. */
#ifndef FABRIC_CHUNK_SUM_H
#define FABRIC_CHUNK_SUM_H

#include <assert.h>

enum { CHUNK_SUM_LEAST = 256, CHUNK_SUM_MOST = 512 };

static inline int chunk_sum_length(int count) {
    const int length = (count + CHUNK_SUM_MOST - 1) / CHUNK_SUM_MOST;
    return length > CHUNK_SUM_LEAST ? length : CHUNK_SUM_LEAST;
}

static inline int chunk_sum_chunks(int count) {
    const int length = chunk_sum_length(count);
    return (count + length - 1) / length;
}

/** One past the index of the chunk's last item. */
static inline int chunk_sum_end(int count, int chunk) {
    const int end = (chunk + 1) * chunk_sum_length(count);
    return end < count ? end : count;
}

static inline double chunk_sum_all(int count, const double *sum) {
    assert(chunk_sum_chunks(count) <= CHUNK_SUM_MOST);
    double all = 0;
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        all += sum[chunk];
    return all;
}

#endif
