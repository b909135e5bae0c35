/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Prefetches of what iterations to come update and read, in the executor of loop.h.
 *
 * The slice of a later iteration of the same thread computes the addresses, as it did for the
 * inspector: it reads what is known to be readable, and unmodified while the loop runs. Nothing is
 * stored, so no result depends on it. Of each row the first byte, the last and each line between
 * are asked for.
 *
 * loop.h includes this file.
 */
#ifndef REDCC_PREFETCH_H
#define REDCC_PREFETCH_H

/** How many iterations ahead. Two are enough for iterations of some hundred operations, which take
 *  as long as a memory access; more of them cost entries of the first-level TLB, and were slower on
 *  shuffled data. */
#define REDCC_PREFETCH_DISTANCE 2

/* 1 in the block of a loop whose iterations are long enough (REDCC_PREFETCH), a constant. */
enum { redcc__prefetches = 0 };

/** In the block of a loop: its executor prefetches, where the runtime finds it worthwhile. */
#define REDCC_PREFETCH enum { redcc__prefetches = 1 }

/* Lines of a row that are asked for: more than this in a row the processor sees by itself. */
enum { redcc_prefetch_line = 64, redcc_prefetch_most = 256 };

/** Asks for a row. The address need not be valid. */
REDCC_INLINE void redcc_prefetch(const char *address, redcc_size bytes) {
    redcc_size at;
    for (at = 0; at < bytes && at < redcc_prefetch_most; at += redcc_prefetch_line)
        __builtin_prefetch((const void *)((redcc_size)address + at));
    if (bytes > redcc_prefetch_line / 4) /* a scalar does not straddle lines */
        __builtin_prefetch((const void *)((redcc_size)address + bytes - 1));
}

/** In the slice: the iteration reads redcc_base[redcc_row], which nobody need be told. */
#define REDCC_AHEAD(redcc_base, redcc_row)                                                         \
    if (!redcc__worker)                                                                            \
    redcc_prefetch((const char *)((redcc_size)(redcc_base) +                                       \
                                  (redcc_size)(redcc_row) * sizeof(*(redcc_base))),                \
                   sizeof(*(redcc_base)))

/** The iteration that lies so far ahead in the runs at hand. */
typedef struct redcc_ahead {
    redcc_int k;
    redcc_int end; /* of its run */
    redcc_int origin;
    const redcc_run *run; /* the next one */
    const redcc_run *run_end;
} redcc_ahead;

/** On to the next run. Returns 0: there is none left. */
REDCC_INLINE int redcc_ahead_turn(redcc_ahead *it) {
    for (; it->run != it->run_end; it->run++) {
        it->k = it->origin + it->run->begin;
        it->end = it->k + it->run->count_and_guard / 2;
        if (it->k < it->end) {
            it->run++;
            return 1;
        }
    }
    it->k = it->end;
    return 0;
}

/** On to the next iteration. Returns 0: there is none left, or nothing is to be prefetched. */
REDCC_INLINE int redcc_ahead_step(redcc_ahead *it) {
    return ++it->k < it->end || redcc_ahead_turn(it);
}

/** Begins in front of iteration number `distance` of the runs; with no wish for it at their end. */
REDCC_INLINE void redcc_ahead_begin(redcc_ahead *it, const redcc_worker *worker, int is_wanted,
                                    int distance) {
    it->k = it->end = 0;
    it->origin = worker->origin;
    it->run = is_wanted ? worker->run : 0;
    it->run_end = is_wanted ? worker->run_end : 0;
    for (; distance > 0; distance--)
        redcc_ahead_step(it);
}

/** Goes before an iteration: the slice, of the one ahead; without a worker it prefetches. */
#define REDCC_PREFETCH_ONE(redcc_call_of_slice)                                                    \
    if (redcc__prefetches && redcc_ahead_step(&redcc__ahead)) {                                    \
        redcc_probe *const redcc__probe = 0;                                                       \
        redcc_worker *const redcc__teller = 0;                                                     \
        const redcc_u32 redcc__told = 0;                                                           \
        const redcc_int redcc__k = redcc__ahead.k;                                                 \
        redcc_call_of_slice;                                                                       \
    }

#endif
