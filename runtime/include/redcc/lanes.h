/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Several iterations at once, as the lanes of vectors of doubles (docs/lanes.md). What is computed
 * is computed for all of them by one operation each; updates are made lane by lane, in the order in
 * which the iterations would have been executed.
 *
 * Generated text says how many lanes by REDCC_WIDTH_AUTO, or 2, 4 or 8, in REDCC_LANES_BEGIN, and
 * includes this file where it uses them; runtime.h comes before it.
 */
#ifndef REDCC_LANES_H
#define REDCC_LANES_H

/* Vectors are passed between functions that are inlined: that their passing changed between
 * versions of a compiler does not matter. */
#pragma GCC diagnostic ignored "-Wpsabi"

/** As many doubles as a vector register holds. */
#if defined(__AVX512F__)
#define REDCC_WIDTH_AUTO 8
#elif defined(__AVX__)
#define REDCC_WIDTH_AUTO 4
#else
#define REDCC_WIDTH_AUTO 2
#endif

#ifndef redcc_width
#define redcc_width REDCC_WIDTH_AUTO
#endif

typedef double redcc_vector __attribute__((__vector_size__(8 * redcc_width)));
__extension__ typedef long long redcc_mask __attribute__((__vector_size__(8 * redcc_width)));

/** Is each operation rounded by itself, in vectors as in scalars? */
#if REDCC_ROUNDS_ALIKE
enum { redcc_lanes_are_alike = 1 };
#else
enum { redcc_lanes_are_alike = 0 };
#endif

/** The statement that follows, for each lane, redcc__l. */
#define REDCC_EACH_LANE for (redcc__l = 0; redcc__l < redcc_width; redcc__l++)

/* An expression of redcc__l, for each lane; as initialisers, since a loop would go through memory.
 */
#define REDCC_LANE(redcc_i, ...)                                                                   \
    __extension__({                                                                                \
        enum { redcc__l = redcc_i };                                                               \
        __VA_ARGS__;                                                                               \
    })
#if redcc_width == 2
#define REDCC_ALL(...) REDCC_LANE(0, __VA_ARGS__), REDCC_LANE(1, __VA_ARGS__)
#elif redcc_width == 4
#define REDCC_ALL(...)                                                                             \
    REDCC_LANE(0, __VA_ARGS__), REDCC_LANE(1, __VA_ARGS__), REDCC_LANE(2, __VA_ARGS__),            \
        REDCC_LANE(3, __VA_ARGS__)
#else
#define REDCC_ALL(...)                                                                             \
    REDCC_LANE(0, __VA_ARGS__), REDCC_LANE(1, __VA_ARGS__), REDCC_LANE(2, __VA_ARGS__),            \
        REDCC_LANE(3, __VA_ARGS__), REDCC_LANE(4, __VA_ARGS__), REDCC_LANE(5, __VA_ARGS__),        \
        REDCC_LANE(6, __VA_ARGS__), REDCC_LANE(7, __VA_ARGS__)
#endif

/** A double for each lane. */
#define REDCC_GATHER(...) (__extension__(redcc_vector){REDCC_ALL(__VA_ARGS__)})

/** Something else for each lane, as an array. */
#define REDCC_EACH(redcc_type, ...)                                                                \
    (__extension__(__typeof__(redcc_type)[redcc_width]){REDCC_ALL(__VA_ARGS__)})

/** The same double in each lane. (Not by addition of 0: it would change -0.0.) */
REDCC_INLINE redcc_vector redcc_same(double value) {
    int redcc__l;
    redcc_vector all;
    REDCC_EACH_LANE all[redcc__l] = value;
    return all;
}

/** Of the lanes where the mask is -1 the one, else the other. */
REDCC_INLINE redcc_vector redcc_select(redcc_mask mask, redcc_vector yes, redcc_vector no) {
    return (redcc_vector)(((redcc_mask)yes & mask) | ((redcc_mask)no & ~mask));
}

/** Each lane by itself: where one is negative errno is set as it is sequentially. */
REDCC_INLINE redcc_vector redcc_lanes_sqrt(redcc_vector value) {
    int redcc__l;
    redcc_vector root;
    REDCC_EACH_LANE root[redcc__l] = __builtin_sqrt(value[redcc__l]);
    return root;
}

REDCC_INLINE redcc_vector redcc_lanes_fabs(redcc_vector value) {
    int redcc__l;
    redcc_vector result;
    REDCC_EACH_LANE result[redcc__l] = __builtin_fabs(value[redcc__l]);
    return result;
}

/** Iterations that are executed at once, and whether their updates must ask redcc_owns. */
typedef struct redcc_block {
    redcc_int k[redcc_width];
    int guarded[redcc_width];
} redcc_block;

/** Takes the next iterations of the runs in order. Returns how many: less than redcc_width at the
 *  end. */
REDCC_INLINE int redcc_block_take(redcc_block *block, redcc_ahead *from) {
    int count = 0;
    for (; count < redcc_width && redcc_ahead_step(from); count++) {
        block->k[count] = from->k;
        block->guarded[count] = (int)(from->run[-1].count_and_guard & 1);
    }
    return count;
}

/** As REDCC_EXECUTE, with what executes redcc_width iterations, redcc__block. Those that are left
 * at the end are executed one by one. */
#define REDCC_EXECUTE_LANES(redcc_chunk, redcc_call_of_slice, redcc_call_of_body,                  \
                            redcc_call_of_lanes)                                                   \
    while (redcc_next(&redcc__worker)) {                                                           \
        redcc_chunk redcc_ahead redcc__ahead, redcc__from;                                         \
        redcc_block redcc__block;                                                                  \
        int redcc__count, redcc__i;                                                                \
        if (redcc__prefetches)                                                                     \
            redcc_ahead_begin(&redcc__ahead, &redcc__worker, redcc__worker.prefetches,             \
                              redcc_width);                                                        \
        redcc_ahead_begin(&redcc__from, &redcc__worker, 1, 0);                                     \
        do {                                                                                       \
            redcc__count = redcc_block_take(&redcc__block, &redcc__from);                          \
            if (redcc__prefetches)                                                                 \
                for (redcc__i = 0; redcc__i < redcc__count; redcc__i++)                            \
                    REDCC_PREFETCH_ONE(redcc_call_of_slice)                                        \
            if (redcc__count == redcc_width) {                                                     \
                const int redcc__guarded = 0;                                                      \
                redcc_call_of_lanes;                                                               \
            } else {                                                                               \
                for (redcc__i = 0; redcc__i < redcc__count; redcc__i++) {                          \
                    const int redcc__guarded = redcc__block.guarded[redcc__i];                     \
                    const redcc_int redcc__k = redcc__block.k[redcc__i];                           \
                    redcc_call_of_body;                                                            \
                }                                                                                  \
            }                                                                                      \
        } while (redcc__count == redcc_width);                                                     \
    }

/** As REDCC_PARALLEL. */
#define REDCC_PARALLEL_LANES(redcc_chunk, redcc_call_of_slice, redcc_call_of_body,                 \
                             redcc_call_of_lanes)                                                  \
    {                                                                                              \
        redcc_worker redcc__worker;                                                                \
        redcc_worker *const redcc__teller = &redcc__worker;                                        \
        redcc_int redcc__k;                                                                        \
        redcc_join(&redcc__worker, &redcc__call, omp_get_thread_num(), omp_get_num_threads());     \
        REDCC_INSPECT(redcc_call_of_slice)                                                         \
        if (redcc_lanes_are_alike) {                                                               \
            REDCC_EXECUTE_LANES(redcc_chunk, redcc_call_of_slice, redcc_call_of_body,              \
                                redcc_call_of_lanes)                                               \
        } else {                                                                                   \
            REDCC_EXECUTE(redcc_chunk, redcc_call_of_slice, redcc_call_of_body)                    \
        }                                                                                          \
    }

#endif
