/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops whose OpenMP directive reduces scalars. They are executed in blocks whose number depends
 * only on the trip count, so that sums have the same bits at every number of threads. This needs no
 * runtime. If a runtime is linked, REDCC_ORDER=serial makes all iterations one block, which begins
 * with the variables' own values and so gives the bits of the sequential loop.
 */
#ifndef REDCC_BLOCKS_H
#define REDCC_BLOCKS_H

/** The number of iterations of a loop from `redcc_low` to before `redcc_high` (REDCC_TRIP) or up to
 * it (REDCC_TRIP_TO), in steps of `redcc_step` > 0. `redcc_low` and `redcc_high` have the counter's
 * type. */
#define REDCC_TRIP(redcc_low, redcc_high, redcc_step)                                              \
    ((redcc_low) < (redcc_high)                                                                    \
         ? (redcc_int)(((redcc_word)(redcc_high) - (redcc_word)(redcc_low)-1) / (redcc_step)) + 1  \
         : 0)
#define REDCC_TRIP_TO(redcc_low, redcc_high, redcc_step)                                           \
    ((redcc_low) <= (redcc_high)                                                                   \
         ? (redcc_int)(((redcc_word)(redcc_high) - (redcc_word)(redcc_low)) / (redcc_step)) + 1    \
         : 0)

/** The number of blocks, at most redcc_max. REDCC_BLOCKS_LONG is for loops of long iterations.
 * REDCC_BLOCKS_SHORT is redcc_max if each block then has at least 64 iterations. Otherwise it is
 * the largest power of two for which they do, or 1 if the loop is too short for two blocks. A power
 * of two can be divided evenly among 2, 4 or 8 threads. */
#define REDCC_BLOCKS_LONG(redcc_trip, redcc_max)                                                   \
    ((redcc_trip) < (redcc_max) ? (redcc_trip) : (redcc_max))
#define REDCC_BLOCKS_SHORT(redcc_trip, redcc_max) redcc_blocks_short(redcc_trip, redcc_max)
REDCC_INLINE redcc_int redcc_blocks_short(redcc_int trip, redcc_int most) {
    const redcc_word least = (redcc_word)trip / 64;
    if (trip <= 0)
        return 0;
    if (least >= (redcc_word)most)
        return most;
    return least < 2 ? 1 : (redcc_int)1 << (63 - __builtin_clzll(least));
}

/** The number of parts into which the inner loop of a nest is divided if the outer loop is divided
 * into redcc_rows parts. _SHORT and _LONG as for REDCC_BLOCKS_SHORT and _LONG. */
#define REDCC_COLUMNS_SHORT(redcc_rows, redcc_trip, redcc_max)                                     \
    ((redcc_rows) < 1 || (redcc_trip) < 1                                                          \
         ? 0                                                                                       \
         : redcc_blocks_short(redcc_trip, (redcc_max) / (redcc_rows)))
#define REDCC_COLUMNS_LONG(redcc_rows, redcc_trip, redcc_max)                                      \
    ((redcc_rows) < 1 || (redcc_trip) < 1                                                          \
         ? 0                                                                                       \
         : REDCC_BLOCKS_LONG(redcc_trip, (redcc_max) / (redcc_rows)))

/** The counter's value in the first iteration of part redcc_number, if the loop is divided into
 * redcc_parts parts; minus redcc_back steps. */
#define REDCC_PART_BEGIN(redcc_low, redcc_trip, redcc_parts, redcc_number, redcc_step, redcc_back) \
    ((redcc_word)(redcc_low) +                                                                     \
     (redcc_word)(redcc_block_begin(redcc_trip, redcc_parts, redcc_number) - (redcc_back)) *       \
         (redcc_word)(redcc_step))
REDCC_INLINE redcc_int redcc_block_begin(redcc_int trip, redcc_int blocks, redcc_int number) {
    const redcc_int longer = trip % blocks;
    return number * (trip / blocks) + (number < longer ? number : longer);
}

/** Adds the number of blocks that the calling thread has executed to the team's count. True for the
 * one thread that completes the count; that thread also resets the count for the loop's next
 * execution. */
#define REDCC_IS_LAST(redcc_ended, redcc_mine, redcc_blocks)                                       \
    ((redcc_mine) > 0 &&                                                                           \
     __atomic_add_fetch(redcc_ended, redcc_mine, __ATOMIC_ACQ_REL) == (redcc_blocks) &&            \
     ((*(redcc_ended) = 0), 1))

/** Does REDCC_ORDER or REDCC_METHOD require the bits of the sequential loop? */
#define REDCC_IN_ORDER(redcc_site) (redcc_run && redcc_is_in_order(&(redcc_site)))
REDCC_INLINE int redcc_is_in_order(redcc_site *site) {
    return redcc_is_known(site) && redcc_calls_of(site)->before->is_in_order(&site->binned.loop);
}

/** The neutral element of the minimum. redcc_type is FLT, DBL or LDBL. */
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#define REDCC_GREATEST(redcc_type) __##redcc_type##_MAX__
#else
#define REDCC_GREATEST(redcc_type) __builtin_inf()
#endif

#endif
