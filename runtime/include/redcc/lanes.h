/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Executes four iterations at once, as the lanes of vectors of doubles and floats (docs/lanes.md).
 * One operation computes a value in all four lanes. Updates are made lane by lane, in the
 * sequential order of the iterations.
 *
 * Generated text includes this file after runtime.h and after the pragmas that forbid contraction.
 * On x86-64 the vector functions are compiled for AVX2 even if the program is not; the runtime
 * checks that the processor has AVX2. On 64-bit ARM there are two lanes. On other processors
 * iterations are executed one by one.
 */
#ifndef REDCC_LANES_H
#define REDCC_LANES_H

/* gcc with -std=gnu89 -Wpedantic warns about variadic macros. */
#pragma GCC system_header

/** The number of iterations executed at once. 0: iterations are executed one by one, because
 * compilers may round operations differently (REDCC_ROUNDS_ALIKE) or the processor or compiler has
 * no suitable vectors. gcc before 9 has no __builtin_convertvector. */
#ifdef REDCC_IS_CHECKED
#define REDCC_WIDTH 4 /* for redcc's check of its own output */
#elif !REDCC_ROUNDS_ALIKE || (!defined(__clang__) && __GNUC__ < 9)
#define REDCC_WIDTH 0
#elif defined(__x86_64__)
#define REDCC_WIDTH 4
#elif defined(__aarch64__)
#define REDCC_WIDTH 2
#else
#define REDCC_WIDTH 0
#endif

/** The flags of redcc_loop for the vector form. */
#if REDCC_WIDTH == 4 && !defined(__AVX2__)
#define REDCC_LANES (REDCC_LANES_UNIT * REDCC_WIDTH)
#else
#define REDCC_LANES (REDCC_LANES_UNIT * REDCC_WIDTH | REDCC_LANES_ANYWHERE)
#endif

#if REDCC_WIDTH
/* The ABI of vector arguments differs between compiler versions. That has no effect here, because
 * vectors are passed only between inlined functions. */
#pragma GCC diagnostic ignored "-Wpsabi"

/** The attribute that selects the instruction set of vector functions. */
#if defined(REDCC_IS_CHECKED) || !defined(__x86_64__) || defined(__AVX2__)
#define REDCC_TARGET
#else
#define REDCC_TARGET __attribute__((__target__("avx2")))
#endif

/** Suppresses one more warning; follows REDCC_QUIET_BEGIN. */
#define REDCC_QUIET_LANES _Pragma("GCC diagnostic ignored \"-Wdeclaration-after-statement\"")

/* ---- lanes ---------------------------------------------------------------------------------- */

/* Evaluates an expression for each lane (redcc__l is the lane's number) and makes a list of
 * initialisers of the values. If a loop over the lanes stored them instead, compilers would store
 * them to memory and load them again. */
#define REDCC_LANE(redcc_i, ...)                                                                   \
    __extension__({                                                                                \
        enum { redcc__l = redcc_i };                                                               \
        __VA_ARGS__;                                                                               \
    })
#if REDCC_WIDTH == 4
#define REDCC_ALL(...)                                                                             \
    REDCC_LANE(0, __VA_ARGS__), REDCC_LANE(1, __VA_ARGS__), REDCC_LANE(2, __VA_ARGS__),            \
        REDCC_LANE(3, __VA_ARGS__)
#else
#define REDCC_ALL(...) REDCC_LANE(0, __VA_ARGS__), REDCC_LANE(1, __VA_ARGS__)
#endif

/** Qualifiers of an inlined vector function, and of the body that executes REDCC_WIDTH iterations.
 */
#define REDCC_VECTOR_INLINE REDCC_INLINE REDCC_TARGET
#define REDCC_LANES_BODY static __attribute__((__noinline__, __unused__)) REDCC_TARGET void

/** Executes the following statement for each lane redcc__l (REDCC_EACH_LANE), or for each lane that
 * has an iteration (REDCC_EACH_ITERATION). */
#define REDCC_EACH_LANE for (redcc__l = 0; redcc__l < REDCC_WIDTH; redcc__l++)
#define REDCC_EACH_ITERATION for (redcc__l = 0; redcc__l < redcc__block->count; redcc__l++)

/** redcc_vector: doubles, one for each lane. redcc_floats: as many floats. redcc_mask and
 * redcc_float_mask: masks for these, with -1 or 0 in each lane. */
typedef double redcc_vector __attribute__((__vector_size__(8 * REDCC_WIDTH)));
typedef float redcc_floats __attribute__((__vector_size__(4 * REDCC_WIDTH)));
__extension__ typedef long long redcc_mask __attribute__((__vector_size__(8 * REDCC_WIDTH)));
typedef int redcc_float_mask __attribute__((__vector_size__(4 * REDCC_WIDTH)));

/** Evaluates a double, or a float, for each lane and makes a vector of them. */
#define REDCC_GATHER(...) (__extension__(redcc_vector){REDCC_ALL(__VA_ARGS__)})
#define REDCC_GATHER_FLOATS(...) (__extension__(redcc_floats){REDCC_ALL(__VA_ARGS__)})

/** A mask of the lanes in which the value is not 0. */
#define REDCC_MASK(...) (__extension__(redcc_mask){REDCC_ALL(-(redcc_int)((__VA_ARGS__) != 0))})

/** Evaluates an expression of type redcc_type for each lane, and makes an array of the values. */
#define REDCC_EACH(redcc_type, ...)                                                                \
    (__extension__(__typeof__(redcc_type)[REDCC_WIDTH]){REDCC_ALL(__VA_ARGS__)})

/** redcc_doubles_of, redcc_floats_of: convert each lane as C does. redcc_mask_of_floats: converts a
 * redcc_float_mask to a redcc_mask. */
#define redcc_doubles_of(...) __builtin_convertvector((__VA_ARGS__), redcc_vector)
#define redcc_floats_of(...) __builtin_convertvector((__VA_ARGS__), redcc_floats)
#define redcc_mask_of_floats(...) __builtin_convertvector((__VA_ARGS__), redcc_mask)

/** Returns a vector that has the value in each lane. (Adding the value to a vector of zeros would
 * change -0.0.) */
REDCC_VECTOR_INLINE redcc_vector redcc_same(double value) {
    return (__extension__(redcc_vector){REDCC_ALL(value)});
}
REDCC_VECTOR_INLINE redcc_floats redcc_same_float(float value) {
    return (__extension__(redcc_floats){REDCC_ALL(value)});
}

/** For each lane: the first value if the mask is -1, else the second. */
REDCC_VECTOR_INLINE redcc_vector redcc_select(redcc_mask mask, redcc_vector yes, redcc_vector no) {
    return (redcc_vector)(((redcc_mask)yes & mask) | ((redcc_mask)no & ~mask));
}
REDCC_VECTOR_INLINE redcc_floats redcc_select_floats(redcc_mask lanes, redcc_floats yes,
                                                     redcc_floats no) {
    const redcc_float_mask mask = __builtin_convertvector(lanes, redcc_float_mask);
    return (redcc_floats)(((redcc_float_mask)yes & mask) | ((redcc_float_mask)no & ~mask));
}

/* Vector square roots in assembly. For __builtin_sqrt of each lane, compilers would call the
 * library's function, because it may have to set errno. In the assembly text, the operand order
 * after `|` is for -masm=intel. */
#if defined(__x86_64__) && !defined(REDCC_IS_CHECKED)
#define REDCC_ROOTS(redcc_root, redcc_v)                                                           \
    __asm__("vsqrtpd {%1, %0|%0, %1}" : "=x"(redcc_root) : "x"(redcc_v))
REDCC_VECTOR_INLINE int redcc_any(redcc_mask mask) {
    int signs;
    __asm__("vmovmskpd {%1, %0|%0, %1}" : "=r"(signs) : "x"(mask));
    return signs != 0;
}
#else
#define REDCC_ROOTS(redcc_root, redcc_v) redcc_root = redcc_each_root(redcc_v)
REDCC_VECTOR_INLINE int redcc_any(redcc_mask mask) {
    redcc_int all = 0;
    int l;
    for (l = 0; l < REDCC_WIDTH; l++)
        all |= mask[l];
    return all < 0;
}
#endif

/** Square roots lane by lane, so that errno is set as in the sequential loop. */
static __attribute__((__noinline__, __unused__)) REDCC_TARGET redcc_vector
redcc_each_root(redcc_vector value) {
    return (__extension__(redcc_vector){REDCC_ALL(__builtin_sqrt(value[redcc__l]))});
}

/** Square roots of all lanes at once; if a lane is negative, redcc_each_root sets errno. */
REDCC_VECTOR_INLINE redcc_vector redcc_lanes_sqrt(redcc_vector value) {
    redcc_vector root;
    if (redcc_any((redcc_mask)value < 0))
        return redcc_each_root(value);
    REDCC_ROOTS(root, value);
    return root;
}
/** Absolute values. fabs never sets errno, so compilers need no calls and compute all lanes with
 * one instruction. */
REDCC_VECTOR_INLINE redcc_vector redcc_lanes_fabs(redcc_vector value) {
    return (__extension__(redcc_vector){REDCC_ALL(__builtin_fabs(value[redcc__l]))});
}
REDCC_VECTOR_INLINE redcc_floats redcc_lanes_sqrtf(redcc_floats value) {
    return (__extension__(redcc_floats){REDCC_ALL(__builtin_sqrtf(value[redcc__l]))});
}
REDCC_VECTOR_INLINE redcc_floats redcc_lanes_fabsf(redcc_floats value) {
    return (__extension__(redcc_floats){REDCC_ALL(__builtin_fabsf(value[redcc__l]))});
}

/** Tests at run time that vector functions round a product before an addition, and that floating
 * constants are doubles. No macro reveals the options -ffp-contract=fast, which overrides clang's
 * pragmas, and -fsingle-precision-constant. */
static __attribute__((__noinline__, __unused__)) REDCC_TARGET int redcc_lanes_round_alike(void) {
    const volatile double factor = 134217729.0, less = 18014398777917440.0;
    const volatile double square = factor * factor, rest = square - less;
    const redcc_vector factors = redcc_same(factor);
    const redcc_vector rests = factors * factors - redcc_same(less);
    return rests[0] == rest && factors[1] * factors[1] - less == rest &&
           sizeof 1.0 == sizeof(double);
}

/* ---- the executor ---------------------------------------------------------------------------- */

/** Iterations that are executed at once, and for each whether its updates must check the owner. If
 * fewer than REDCC_WIDTH are left, `count` is the number of those; the other lanes compute the last
 * iteration again, but update nothing. */
typedef struct redcc_block {
    redcc_int k[REDCC_WIDTH];
    int checked[REDCC_WIDTH];
    int count;
} redcc_block;

/** Fills the block with the next iterations of the runs, in order. Returns the number of these
 * iterations, 0 if none is left. */
REDCC_INLINE int redcc_block_fill(redcc_block *block, redcc_ahead *from) {
    int count = 0, l;
    for (; count < REDCC_WIDTH && redcc_ahead_step(from); count++) {
        block->k[count] = from->k;
        block->checked[count] = (int)(from->run[-1].count_and_check & 1);
    }
    for (l = count; count && l < REDCC_WIDTH; l++)
        block->k[l] = block->k[count - 1];
    block->count = count;
    return count;
}

/** Slice and body for one iteration, each compiled once, as a separate function. The scalar body
 * executes all iterations, owner-checked or not, if the processor lacks AVX2 or REDCC_LANES=off is
 * set. */
#define REDCC_SLICE_OF_LANES REDCC_SLICE_ONCE
#define REDCC_LANES_BY_CALLS REDCC_BY_CALLS
#define REDCC_SCALAR_BODY static __attribute__((__noinline__, __unused__)) void

/** Executes chunks, REDCC_WIDTH iterations at once. */
#define REDCC_EXECUTE_LANES(redcc_chunk, redcc_call_of_slice, redcc_call_of_body, redcc_name,      \
                            redcc_arguments)                                                       \
    for (;;) {                                                                                     \
        int redcc__chunk_kind;                                                                     \
        REDCC_NEXT_CHUNK(1, redcc_call_of_slice)                                                   \
        if (!redcc__chunk_kind)                                                                    \
            break;                                                                                 \
        {                                                                                          \
            redcc_chunk redcc_block redcc__block;                                                  \
            redcc_ahead redcc__from;                                                               \
            const int redcc__at_once = redcc__worker->variant.lanes && redcc_lanes_round_alike();  \
            REDCC_PREFETCH_BEGIN(redcc__prefetches < REDCC_WIDTH ? REDCC_WIDTH                     \
                                                                 : redcc__prefetches)              \
            redcc__worker->call->calls->ahead->begin(&redcc__from, redcc__worker, 0);              \
            while (redcc_block_fill(&redcc__block, &redcc__from)) {                                \
                int redcc__l;                                                                      \
                for (redcc__l = 0; redcc__is_prefetching && redcc__l < REDCC_WIDTH; redcc__l++)    \
                    REDCC_PREFETCH_ONE(redcc_call_of_slice)                                        \
                if (redcc__at_once) {                                                              \
                    const int redcc__checked = 0;                                                  \
                    redcc_name redcc_arguments;                                                    \
                    (void)redcc__checked;                                                          \
                } else                                                                             \
                    for (redcc__l = 0; redcc__l < redcc__block.count; redcc__l++) {                \
                        const int redcc__checked = redcc__block.checked[redcc__l];                 \
                        redcc__k = redcc__block.k[redcc__l];                                       \
                        redcc_call_of_body;                                                        \
                    }                                                                              \
            }                                                                                      \
        }                                                                                          \
    }

/** As REDCC_PARALLEL, with lanes. */
#define REDCC_PARALLEL_LANES(redcc_chunk, redcc_call_of_slice, redcc_call_of_body, redcc_name,     \
                             redcc_arguments)                                                      \
    {                                                                                              \
        REDCC_JOIN(redcc_call_of_slice)                                                            \
        REDCC_EXECUTE_LANES(redcc_chunk, redcc_call_of_slice, redcc_call_of_body, redcc_name,      \
                            redcc_arguments)                                                       \
    }

#else
#define REDCC_SLICE_OF_LANES REDCC_SLICE
#define REDCC_LANES_BY_CALLS
#define REDCC_SCALAR_BODY REDCC_BODY
#define REDCC_PARALLEL_LANES(redcc_chunk, redcc_call_of_slice, redcc_call_of_body, redcc_name,     \
                             redcc_arguments)                                                      \
    REDCC_PARALLEL(redcc_chunk, redcc_call_of_slice, redcc_call_of_body)
#endif

#endif
