/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Several iterations at once, as the lanes of vectors of doubles and floats (docs/lanes.md). What
 * is computed is computed for all of them by one operation each; updates are made lane by lane, in
 * the order in which the iterations would have been executed.
 *
 * Generated text includes this file behind runtime.h and what forbids contraction. It holds what is
 * for vectors once for each width, behind lanes_width.h, for processors that may know more than
 * what the program is compiled for; the runtime says which width is executed. REDCC_ONLY_WIDTH,
 * defined as 2, 4 or 8: this width alone, for the processor that the program is compiled for.
 */
#ifndef REDCC_LANES_H
#define REDCC_LANES_H

/* By -std=gnu89 -Wpedantic gcc warns of macros with any number of arguments. */
#pragma GCC system_header

/** The widths that are compiled: a sum of 2, 4 and 8. None where operations may be rounded together
 *  or where the compiler does not know the vectors of gcc and clang. Narrower ones than a register
 *  of AVX2 are of no use where the program is compiled for that. */
#if defined(REDCC_IS_CHECKED) && !defined(REDCC_ONLY_WIDTH)
#define REDCC_WIDTHS (2 + 4 + 8) /* redcc looks at its own text */
#elif !defined(REDCC_IS_CHECKED) && !REDCC_ROUNDS_ALIKE
#define REDCC_WIDTHS 0
#elif !defined(__clang__) && __GNUC__ < 9 /* __builtin_convertvector */
#define REDCC_WIDTHS 0
#elif defined(REDCC_ONLY_WIDTH)
#define REDCC_WIDTHS REDCC_ONLY_WIDTH
#elif !defined(__x86_64__)
#define REDCC_WIDTHS 0
#elif defined(__AVX2__)
#define REDCC_WIDTHS (4 + 8) /* also for AVX-512: eight are not always faster than four */
#else
#define REDCC_WIDTHS (2 + 4 + 8)
#endif

/** In the descriptor's flags. */
#ifdef REDCC_ONLY_WIDTH
#define REDCC_LANES (REDCC_LANES_UNIT * REDCC_WIDTHS | REDCC_LANES_ANYWHERE)
#else
#define REDCC_LANES (REDCC_LANES_UNIT * REDCC_WIDTHS)
#endif

/* Vectors are passed between functions that are inlined: that their passing changed between
 * versions of a compiler does not matter. */
#if REDCC_WIDTHS
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

/** What functions are compiled for. */
#define REDCC_TARGET_2
#if defined(REDCC_ONLY_WIDTH) || defined(REDCC_IS_CHECKED) || defined(__AVX2__)
#define REDCC_TARGET_4
#else
#define REDCC_TARGET_4 __attribute__((__target__("avx2")))
#endif
#if defined(REDCC_ONLY_WIDTH) || defined(REDCC_IS_CHECKED) ||                                      \
    (defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__))
#define REDCC_TARGET_8
#elif defined(__clang__)
#define REDCC_TARGET_8                                                                             \
    __attribute__((__target__("avx512f,avx512dq,avx512vl"), __min_vector_width__(512)))
#else
#define REDCC_TARGET_8                                                                             \
    __attribute__((__target__("avx512f,avx512dq,avx512vl,prefer-vector-width=512")))
#endif

/* An expression of redcc__l, for each lane; as initialisers, since a loop would go through memory.
 */
#define REDCC_LANE(redcc_i, ...)                                                                   \
    __extension__({                                                                                \
        enum { redcc__l = redcc_i };                                                               \
        __VA_ARGS__;                                                                               \
    })
#define REDCC_ALL_2(...) REDCC_LANE(0, __VA_ARGS__), REDCC_LANE(1, __VA_ARGS__)
#define REDCC_ALL_4(...)                                                                           \
    REDCC_ALL_2(__VA_ARGS__), REDCC_LANE(2, __VA_ARGS__), REDCC_LANE(3, __VA_ARGS__)
#define REDCC_ALL_8(...)                                                                           \
    REDCC_ALL_4(__VA_ARGS__), REDCC_LANE(4, __VA_ARGS__), REDCC_LANE(5, __VA_ARGS__),              \
        REDCC_LANE(6, __VA_ARGS__), REDCC_LANE(7, __VA_ARGS__)

#include "lanes_x86.h"
#ifndef REDCC_ROOTS_2
#define REDCC_ROOTS_2(redcc_root, redcc_v) redcc_root = redcc_each_root(redcc_v)
#define REDCC_SIGNS_2(redcc_m) ((redcc_m[0] | redcc_m[1]) < 0)
#endif
#ifndef REDCC_ROOTS_4
#define REDCC_ROOTS_4(redcc_root, redcc_v) redcc_root = redcc_each_root(redcc_v)
#define REDCC_SIGNS_4(redcc_m) ((redcc_m[0] | redcc_m[1] | redcc_m[2] | redcc_m[3]) < 0)
#endif
#ifndef REDCC_ROOTS_8
#define REDCC_ROOTS_8(redcc_root, redcc_v) redcc_root = redcc_each_root(redcc_v)
#define REDCC_SIGNS_8(redcc_m)                                                                     \
    ((redcc_m[0] | redcc_m[1] | redcc_m[2] | redcc_m[3] | redcc_m[4] | redcc_m[5] | redcc_m[6] |   \
      redcc_m[7]) < 0)
#endif

/* ---- what lanes_width.h gives a meaning ------------------------------------------------------ */

#define redcc_vector REDCC_WIDE(redcc_vector)
#define redcc_floats REDCC_WIDE(redcc_floats)
#define redcc_mask REDCC_WIDE(redcc_mask)
#define redcc_float_mask REDCC_WIDE(redcc_float_mask)

/** A function that is inlined, and the one that executes redcc_width iterations. */
#define REDCC_LIFTED REDCC_INLINE REDCC_TARGET
#define REDCC_LANES_BODY static __attribute__((__noinline__, __unused__)) REDCC_TARGET void

/** The statement that follows, for each lane, redcc__l. */
#define REDCC_EACH_LANE for (redcc__l = 0; redcc__l < redcc_width; redcc__l++)

/** A double for each lane, and a float. */
#define REDCC_GATHER(...) (__extension__(redcc_vector){REDCC_ALL(__VA_ARGS__)})
#define REDCC_GATHER_FLOATS(...) (__extension__(redcc_floats){REDCC_ALL(__VA_ARGS__)})

/** The lanes of which it is not 0. */
#define REDCC_TELL(...) (__extension__(redcc_mask){REDCC_ALL(-(redcc_int)((__VA_ARGS__) != 0))})

/** Something else for each lane, as an array. */
#define REDCC_EACH(redcc_type, ...)                                                                \
    (__extension__(__typeof__(redcc_type)[redcc_width]){REDCC_ALL(__VA_ARGS__)})

#define redcc_same REDCC_WIDE(redcc_same)
#define redcc_same_float REDCC_WIDE(redcc_same_float)
#define redcc_select REDCC_WIDE(redcc_select)
#define redcc_select_floats REDCC_WIDE(redcc_select_floats)
#define redcc_doubles_of(...) __builtin_convertvector((__VA_ARGS__), redcc_vector)
#define redcc_floats_of(...) __builtin_convertvector((__VA_ARGS__), redcc_floats)
#define redcc_mask_of_floats(...) __builtin_convertvector((__VA_ARGS__), redcc_mask)
#define redcc_any REDCC_WIDE(redcc_any)
#define redcc_each_root REDCC_WIDE(redcc_each_root)
#define REDCC_ROOTS REDCC_WIDE(REDCC_ROOTS)
#define REDCC_SIGNS REDCC_WIDE(REDCC_SIGNS)
#define redcc_lanes_sqrt REDCC_WIDE(redcc_lanes_sqrt)
#define redcc_lanes_fabs REDCC_WIDE(redcc_lanes_fabs)
#define redcc_lanes_sqrtf REDCC_WIDE(redcc_lanes_sqrtf)
#define redcc_lanes_fabsf REDCC_WIDE(redcc_lanes_fabsf)

/**
 * redcc_floats: as many floats as there are doubles in a redcc_vector.
 * redcc_mask: of lanes, of doubles and floats alike.
 * redcc_same: the same double in each lane (not by addition of 0: it would change -0.0).
 * redcc_select: of the lanes where the mask is -1 the one, else the other.
 * redcc_doubles_of, redcc_floats_of: each lane converted as C converts.
 * redcc_mask_of_floats: the lanes of which a comparison of floats holds.
 * redcc_any: is there a lane in the mask?
 * redcc_each_root: lane by lane, where errno is set as it is sequentially.
 * redcc_lanes_sqrt: all lanes at once; where one is negative redcc_each_root, for errno.
 * redcc_rounds_alike: is a product rounded before it is added to, in functions of this kind, and
 * is a constant a double? No macro tells of -ffp-contract=fast, which clang prefers to pragmas, nor
 * of -fsingle-precision-constant.
 */
#define REDCC_LANES_TOOLS                                                                          \
    typedef double redcc_vector __attribute__((__vector_size__(8 * redcc_width)));                 \
    typedef float redcc_floats __attribute__((__vector_size__(4 * redcc_width)));                  \
    __extension__ typedef long long redcc_mask __attribute__((__vector_size__(8 * redcc_width)));  \
    typedef int redcc_float_mask __attribute__((__vector_size__(4 * redcc_width)));                \
    REDCC_LIFTED redcc_vector redcc_same(double value) {                                           \
        return (__extension__(redcc_vector){REDCC_ALL(value)});                                    \
    }                                                                                              \
    REDCC_LIFTED redcc_floats redcc_same_float(float value) {                                      \
        return (__extension__(redcc_floats){REDCC_ALL(value)});                                    \
    }                                                                                              \
    REDCC_LIFTED redcc_vector redcc_select(redcc_mask mask, redcc_vector yes, redcc_vector no) {   \
        return (redcc_vector)(((redcc_mask)yes & mask) | ((redcc_mask)no & ~mask));                \
    }                                                                                              \
    REDCC_LIFTED redcc_floats redcc_select_floats(redcc_mask lanes, redcc_floats yes,              \
                                                  redcc_floats no) {                               \
        const redcc_float_mask mask = __builtin_convertvector(lanes, redcc_float_mask);            \
        return (redcc_floats)(((redcc_float_mask)yes & mask) | ((redcc_float_mask)no & ~mask));    \
    }                                                                                              \
    REDCC_LIFTED int redcc_any(redcc_mask mask) {                                                  \
        return REDCC_SIGNS(mask) != 0;                                                             \
    }                                                                                              \
    static __attribute__((__noinline__, __unused__)) REDCC_TARGET redcc_vector redcc_each_root(    \
        redcc_vector value) {                                                                      \
        return (__extension__(redcc_vector){REDCC_ALL(__builtin_sqrt(value[redcc__l]))});          \
    }                                                                                              \
    REDCC_LIFTED redcc_vector redcc_lanes_sqrt(redcc_vector value) {                               \
        redcc_vector root;                                                                         \
        if (redcc_any((redcc_mask)value < 0))                                                      \
            return redcc_each_root(value);                                                         \
        REDCC_ROOTS(root, value);                                                                  \
        return root;                                                                               \
    }                                                                                              \
    REDCC_LIFTED redcc_vector redcc_lanes_fabs(redcc_vector value) {                               \
        return (__extension__(redcc_vector){REDCC_ALL(__builtin_fabs(value[redcc__l]))});          \
    }                                                                                              \
    REDCC_LIFTED redcc_floats redcc_lanes_sqrtf(redcc_floats value) {                              \
        return (__extension__(redcc_floats){REDCC_ALL(__builtin_sqrtf(value[redcc__l]))});         \
    }                                                                                              \
    REDCC_LIFTED redcc_floats redcc_lanes_fabsf(redcc_floats value) {                              \
        return (__extension__(redcc_floats){REDCC_ALL(__builtin_fabsf(value[redcc__l]))});         \
    }                                                                                              \
    static __attribute__((__noinline__, __unused__)) REDCC_TARGET int REDCC_WIDE(                  \
        redcc_rounds_alike)(void) {                                                                \
        const volatile double factor = 134217729.0, less = 18014398777917440.0;                    \
        const volatile double square = factor * factor, rest = square - less;                      \
        const redcc_vector factors = redcc_same(factor);                                           \
        const redcc_vector rests = factors * factors - redcc_same(less);                           \
        return rests[0] == rest && factors[1] * factors[1] - less == rest &&                       \
               sizeof 1.0 == sizeof(double);                                                       \
    }
#if REDCC_WIDTHS & 2
#define redcc_width 2
#include "lanes_width.h"
REDCC_LANES_TOOLS
#endif
#if REDCC_WIDTHS & 4
#undef redcc_width
#define redcc_width 4
#include "lanes_width.h"
REDCC_LANES_TOOLS
#endif
#if REDCC_WIDTHS & 8
#undef redcc_width
#define redcc_width 8
#include "lanes_width.h"
REDCC_LANES_TOOLS
#endif

/* ---- the executor ---------------------------------------------------------------------------- */

enum { REDCC_MOST_LANES = 8 };

/** Iterations that are executed at once, and whether their updates must ask redcc_owns. */
typedef struct redcc_block {
    redcc_int k[REDCC_MOST_LANES];
    int guarded[REDCC_MOST_LANES];
} redcc_block;

/** Takes the next iterations of the runs in order. Returns how many: less than `width` at the end.
 */
REDCC_INLINE int redcc_block_take(redcc_block *block, redcc_ahead *from, int width) {
    int count = 0;
    for (; count < width && redcc_ahead_step(from); count++) {
        block->k[count] = from->k;
        block->guarded[count] = (int)(from->run[-1].count_and_guard & 1);
    }
    return count;
}

/** Writes the first `count` iterations of the block as runs of one each. Returns how many. */
REDCC_INLINE int redcc_block_rest(const redcc_block *block, int count, redcc_int origin,
                                  redcc_iterations *rest) {
    int i;
    for (i = 0; i < count; i++) {
        rest[i].begin = (redcc_u32)(block->k[i] - origin);
        rest[i].count_and_guard = 2 + (redcc_u32)block->guarded[i];
    }
    return count;
}

/** How many iterations at once the runtime says, 0 where they would not be rounded alike. */
REDCC_INLINE int redcc_lanes_of(const redcc_worker *worker) {
    switch (worker->manner.lanes & REDCC_WIDTHS) {
#if REDCC_WIDTHS & 2
    case 2:
        return redcc_rounds_alike_2() ? 2 : 0;
#endif
#if REDCC_WIDTHS & 4
    case 4:
        return redcc_rounds_alike_4() ? 4 : 0;
#endif
#if REDCC_WIDTHS & 8
    case 8:
        return redcc_rounds_alike_8() ? 8 : 0;
#endif
    default:
        return 0;
    }
}

/* The call of the function for so many iterations. */
#if REDCC_WIDTHS & 2
#define REDCC_CASE_2(redcc_name, redcc_arguments)                                                  \
    case 2:                                                                                        \
        redcc_name##_2 redcc_arguments;                                                            \
        break;
#else
#define REDCC_CASE_2(redcc_name, redcc_arguments)
#endif
#if REDCC_WIDTHS & 4
#define REDCC_CASE_4(redcc_name, redcc_arguments)                                                  \
    case 4:                                                                                        \
        redcc_name##_4 redcc_arguments;                                                            \
        break;
#else
#define REDCC_CASE_4(redcc_name, redcc_arguments)
#endif
#if REDCC_WIDTHS & 8
#define REDCC_CASE_8(redcc_name, redcc_arguments)                                                  \
    case 8:                                                                                        \
        redcc_name##_8 redcc_arguments;                                                            \
        break;
#else
#define REDCC_CASE_8(redcc_name, redcc_arguments)
#endif

/** The chunk, as many iterations at once as the runtime says; what is left at its end is executed
 * one by one, as is all of it where there is nothing for vectors. */
#define REDCC_EXECUTE_LANES(redcc_chunk, redcc_call_of_slice, redcc_call_of_body, redcc_name,      \
                            redcc_arguments)                                                       \
    for (;;) {                                                                                     \
        int redcc__asked;                                                                          \
        REDCC_NEXT_CHUNK(1, redcc_call_of_slice)                                                   \
        if (!redcc__asked)                                                                         \
            break;                                                                                 \
        {                                                                                          \
            redcc_chunk const redcc_iterations *redcc__run = redcc__worker->run;                   \
            const redcc_iterations *redcc__run_end = redcc__worker->run_end;                       \
            const int redcc__width = redcc_lanes_of(redcc__worker);                                \
            redcc_iterations redcc__rest[REDCC_MOST_LANES];                                        \
            REDCC_PREFETCH_BEGIN(redcc__width > redcc__prefetches ? redcc__width                   \
                                                                  : redcc__prefetches)             \
            if (redcc__width) {                                                                    \
                const int redcc__guarded = 0;                                                      \
                int redcc__count, redcc__i;                                                        \
                redcc_block redcc__block;                                                          \
                redcc_ahead redcc__from;                                                           \
                redcc_ahead_begin(&redcc__from, redcc__worker, 0);                                 \
                while ((redcc__count = redcc_block_take(&redcc__block, &redcc__from,               \
                                                        redcc__width)) == redcc__width) {          \
                    if (redcc__wished)                                                             \
                        for (redcc__i = 0; redcc__i < redcc__width; redcc__i++)                    \
                            REDCC_PREFETCH_ONE(redcc_call_of_slice)                                \
                    switch (redcc__width) {                                                        \
                        REDCC_CASE_2(redcc_name, redcc_arguments)                                  \
                        REDCC_CASE_4(redcc_name, redcc_arguments)                                  \
                        REDCC_CASE_8(redcc_name, redcc_arguments)                                  \
                    default:                                                                       \
                        (void)redcc__guarded;                                                      \
                    }                                                                              \
                }                                                                                  \
                redcc__run = redcc__rest;                                                          \
                redcc__run_end =                                                                   \
                    redcc__rest + redcc_block_rest(&redcc__block, redcc__count,                    \
                                                   redcc__worker->origin, redcc__rest);            \
            }                                                                                      \
            REDCC_EXECUTE_RUNS(redcc_call_of_slice, redcc_call_of_body)                            \
        }                                                                                          \
    }

/** As REDCC_PARALLEL. */
#define REDCC_PARALLEL_LANES(redcc_chunk, redcc_call_of_slice, redcc_call_of_body, redcc_name,     \
                             redcc_arguments)                                                      \
    {                                                                                              \
        REDCC_JOIN(redcc_call_of_slice)                                                            \
        REDCC_EXECUTE_LANES(redcc_chunk, redcc_call_of_slice, redcc_call_of_body, redcc_name,      \
                            redcc_arguments)                                                       \
    }

#endif
