/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Prefetches of rows that later iterations update and read, in the executor of loop.h.
 *
 * The slice of a later iteration of the same thread computes the addresses, as it does for the
 * inspector. It reads only memory that is known to be readable and that is not modified while the
 * loop runs. The rows that the slice itself reads are prefetched twice as far ahead, if consecutive
 * iterations read rows at equal distances. A prefetch stores nothing, so no result depends on it.
 * Of each row, the cache lines of its first 256 bytes and the cache line of its last byte are
 * prefetched.
 *
 * loop.h includes this file.
 */
#ifndef REDCC_PREFETCH_H
#define REDCC_PREFETCH_H

/* The prefetch distance in iterations; 0: no prefetches. In the block of a loop with long enough
 * iterations, REDCC_PREFETCH declares a constant of the same name with another value, which hides
 * this one. */
enum { redcc__prefetches = 0 };

/** Used in the block of a loop: the executor prefetches this number of iterations ahead, if the
 * runtime finds that profitable. The number is such that these iterations together take as long as
 * a memory access. Larger distances occupied more entries of the first-level TLB and were slower on
 * shuffled data. */
#define REDCC_PREFETCH(redcc_distance) enum { redcc__prefetches = redcc_distance }

/* redcc_prefetch_line: size of a cache line in bytes. redcc_prefetch_most: maximum number of bytes
 * at the beginning of a row that are prefetched; hardware prefetchers detect longer sequences. */
enum { redcc_prefetch_line = 64, redcc_prefetch_most = 256 };

/** Prefetches a row. The address need not be valid. */
REDCC_INLINE void redcc_prefetch(const char *address, redcc_size bytes) {
    /* If a row consists of 8-byte numbers, it begins at a multiple of 8. Then two of its bytes that
     * are at most 71 bytes apart are in the same cache line or in adjacent ones. */
    const redcc_size apart = redcc_prefetch_line - 1 + (bytes % 8 == 0 ? 8 : 1);
    redcc_size at = 0;
    __builtin_prefetch((const void *)(redcc_size)address);
    for (; at + apart + 1 < bytes && at + redcc_prefetch_line < redcc_prefetch_most;) {
        at += redcc_prefetch_line;
        __builtin_prefetch((const void *)((redcc_size)address + at));
    }
    if (bytes > redcc_prefetch_line / 4) /* a scalar does not straddle lines */
        __builtin_prefetch((const void *)((redcc_size)address + bytes - 1));
}

/** Used in the slice, for a row redcc_base[redcc_row] that the iteration reads: prefetches it if
 * the slice is used for prefetching, and does nothing otherwise. */
#define REDCC_AHEAD(redcc_base, redcc_row)                                                         \
    if (!redcc__worker)                                                                            \
    redcc_prefetch((const char *)((redcc_size)(redcc_base) +                                       \
                                  (redcc_size)(redcc_row) * sizeof(*(redcc_base))),                \
                   sizeof(*(redcc_base)))

/** The number of a loop's progressions, which are indexed by source. */
#define REDCC_PROGRESSIONS                                                                         \
    ((int)(sizeof redcc__context->redcc__progressions /                                            \
           sizeof *redcc__context->redcc__progressions))

/** Sets a progression in two calls: the first with the row that iteration 0 reads, the second
 * (is_last) with the row that iteration trip - 1 reads. */
static __attribute__((__noinline__, __unused__)) void
redcc_progression_row(redcc_progression *it, const char *row, redcc_size bytes, int is_last,
                      redcc_int trip) {
    redcc_int step = 0;
    if (!is_last) {
        it->first = (redcc_size)row;
        it->bytes = bytes;
        return;
    }
    if (trip > 1)
        step = ((redcc_int)(redcc_size)row - (redcc_int)it->first) / (trip - 1);
    it->step = step;
    /* Rows that lie further apart than their size are perhaps members of structures. Then the whole
     * structure is prefetched. */
    if (step > (redcc_int)bytes && step <= redcc_prefetch_most)
        it->bytes = (redcc_size)step;
}

/* ---- later iterations ---------------------------------------------------------------------- */

/** Advances to the next iteration. Returns 0 if none is left. */
REDCC_INLINE int redcc_ahead_step(redcc_ahead *it) {
    return ++it->k < it->end || it->calls->next_run(it);
}

/** Prefetches the rows of the progressions in iteration ahead->k. */
REDCC_INLINE void redcc_progressions_prefetch(const redcc_progression *it, int count,
                                              const redcc_ahead *ahead) {
    int i;
    for (i = 0; i < count; i++)
        if (it[i].first) {
            const redcc_size at = it[i].first + (redcc_size)(ahead->k * it[i].step);
            __builtin_prefetch((const void *)at);
            __builtin_prefetch((const void *)(at + it[i].bytes - 1));
            if (it[i].bytes > redcc_prefetch_line)
                ahead->calls->prefetch((const char *)at, it[i].bytes);
        }
}

/** Precedes the execution of the current runs: if prefetching is enabled, starts it redcc_distance
 * iterations ahead. */
#define REDCC_PREFETCH_BEGIN(redcc_distance)                                                       \
    redcc_ahead redcc__ahead, redcc__farther;                                                      \
    redcc_progression redcc__rows[REDCC_PROGRESSIONS];                                             \
    const int redcc__is_prefetching = redcc__prefetches > 0 && redcc__worker->variant.prefetches;  \
    if (redcc__is_prefetching) {                                                                   \
        const redcc_ahead_calls *const redcc__calls = redcc__worker->call->calls->ahead;           \
        redcc__calls->begin(&redcc__ahead, redcc__worker, redcc_distance);                         \
        redcc__calls->begin(&redcc__farther, redcc__worker, 2 * (redcc_distance));                 \
        redcc__calls->rows(redcc__rows, redcc__context->redcc__progressions, REDCC_PROGRESSIONS);  \
    }

/** Precedes each iteration if the loop prefetches. Prefetches the progressions' rows for the
 * iteration 2 * distance ahead. Then runs the slice of the iteration `distance` ahead without a
 * worker, so that it prefetches. */
#define REDCC_PREFETCH_ONE(redcc_call_of_slice)                                                    \
    {                                                                                              \
        if (redcc__is_prefetching && redcc_ahead_step(&redcc__farther))                            \
            redcc_progressions_prefetch(redcc__rows, REDCC_PROGRESSIONS, &redcc__farther);         \
        if (redcc__is_prefetching && redcc_ahead_step(&redcc__ahead)) {                            \
            redcc_probe *const redcc__probe = 0;                                                   \
            redcc_worker *const redcc__recorder = 0;                                               \
            const redcc_u32 redcc__source_mask = 0;                                                \
            const redcc_int redcc__k = redcc__ahead.k;                                             \
            redcc_call_of_slice;                                                                   \
        }                                                                                          \
    }

#endif
