/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/elements.h"

#include <complex.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* gcc vectorises few loops at -O2, so these functions request it. */
#if defined(__clang__)
#define VECTORISED
#else
#define VECTORISED __attribute__((__optimize__("tree-vectorize", "vect-cost-model=dynamic")))
#endif

enum {
    PIECE = 1024
}; /* number of elements that stay in the first-level cache while all copies are merged into them */

#define ALWAYS_INLINE static inline __attribute__((__always_inline__))

/* The arguments of a rule: its name; the stored type; the neutral element; the condition under
 * which merging `x` changes nothing; and the result of combining `b` with `x`. If the condition
 * holds, the element is not written, because perhaps no iteration updated it. */
#define INTEGER_RULES(X, T, S, U, LOWEST, HIGHEST)                                                 \
    X(T##_SUM, U, 0, x == 0, (U)((uintmax_t)b + x))                                                \
    X(T##_PRODUCT, U, 1, x == 1, (U)((uintmax_t)b * x))                                            \
    X(T##_MINIMUM, S, HIGHEST, !(x < *to), x < b ? x : b)                                          \
    X(T##_MAXIMUM, S, LOWEST, !(x > *to), x > b ? x : b)                                           \
    X(T##_AND, U, (U)UINTMAX_MAX, x == (U)UINTMAX_MAX, (U)(b & x))                                 \
    X(T##_OR, U, 0, x == 0, (U)(b | x))                                                            \
    X(T##_XOR, U, 0, x == 0, (U)(b ^ x))

/* The neutral element of a floating-point sum is -0.0, because b + -0.0 is b for every b, including
 * 0.0 and -0.0. */
#define REAL_RULES(X, T, S)                                                                        \
    X(T##_SUM, S, (S)-0.0, x == 0 && signbit(x), b + x)                                            \
    X(T##_PRODUCT, S, 1, x == 1, b * x)                                                            \
    X(T##_MINIMUM, S, (S)INFINITY, !(x < *to), x < b ? x : b)                                      \
    X(T##_MAXIMUM, S, -(S)INFINITY, !(x > *to), x > b ? x : b)

#define COMPLEX_RULES(X, T, S, ZERO)                                                               \
    X(T##_SUM, S, __builtin_complex(ZERO, ZERO),                                                   \
      creal(x) == 0 && signbit(creal(x)) && cimag(x) == 0 && signbit(cimag(x)), b + x)             \
    X(T##_PRODUCT, S, 1, creal(x) == 1 && cimag(x) == 0, b * x)

/* A counter that stops at the array's limit (tool/analysis/reduction/saturation.h). A copy starts
 * at LOWEST, so x - LOWEST is the number of its increments. A merge limits the sum. */
#define COUNTER_RULES(X, T, S, U, LOWEST, HIGHEST)                                                 \
    X(T##_SATURATING, S, LOWEST, x == LOWEST || *to >= (S)limit,                                   \
      (U)((U)x - (U)LOWEST) >= (U)((U)limit - (U)b) ? (S)limit : (S)(U)((U)b + (U)x - (U)LOWEST))

#define ALL_INTEGERS(RULES, X)                                                                     \
    RULES(X, INT8, int8_t, uint8_t, INT8_MIN, INT8_MAX)                                            \
    RULES(X, UINT8, uint8_t, uint8_t, 0, UINT8_MAX)                                                \
    RULES(X, INT16, int16_t, uint16_t, INT16_MIN, INT16_MAX)                                       \
    RULES(X, UINT16, uint16_t, uint16_t, 0, UINT16_MAX)                                            \
    RULES(X, INT32, int32_t, uint32_t, INT32_MIN, INT32_MAX)                                       \
    RULES(X, UINT32, uint32_t, uint32_t, 0, UINT32_MAX)                                            \
    RULES(X, INT64, int64_t, uint64_t, INT64_MIN, INT64_MAX)                                       \
    RULES(X, UINT64, uint64_t, uint64_t, 0, UINT64_MAX)

#define ALL_RULES(X)                                                                               \
    ALL_INTEGERS(INTEGER_RULES, X)                                                                 \
    REAL_RULES(X, FLOAT, float)                                                                    \
    REAL_RULES(X, DOUBLE, double)                                                                  \
    REAL_RULES(X, LONG_DOUBLE, long double)                                                        \
    COMPLEX_RULES(X, FLOAT_COMPLEX, float complex, -0.0f)                                          \
    COMPLEX_RULES(X, DOUBLE_COMPLEX, double complex, -0.0)

#define DEFINE(NAME, TYPE, NEUTRAL, IS_NEUTRAL, COMBINED)                                          \
    static void fill_##NAME(void *to, size_t count) {                                              \
        TYPE *element = to;                                                                        \
        const TYPE neutral = NEUTRAL;                                                              \
        for (size_t i = 0; i < count; i++)                                                         \
            element[i] = neutral;                                                                  \
    }                                                                                              \
    static inline void bring_##NAME(TYPE *to, TYPE x, redcc_word limit) {                          \
        (void)limit;                                                                               \
        if (!(IS_NEUTRAL)) {                                                                       \
            const TYPE b = *to;                                                                    \
            *to = COMBINED;                                                                        \
        }                                                                                          \
    }                                                                                              \
    static void merge_##NAME(void *to, const void *from, size_t count, redcc_word limit) {         \
        TYPE *element = to;                                                                        \
        const TYPE *other = from;                                                                  \
        for (size_t i = 0; i < count; i++)                                                         \
            bring_##NAME(&element[i], other[i], limit);                                            \
    }                                                                                              \
    static void merge_all_##NAME(void *to, const void *const *from, size_t copies, size_t count,   \
                                 redcc_word limit) {                                               \
        TYPE *element = to;                                                                        \
        for (size_t i = 0; i < count; i++)                                                         \
            for (size_t copy = 0; copy < copies; copy++)                                           \
                bring_##NAME(&element[i], ((const TYPE *)from[copy])[i], limit);                   \
    }                                                                                              \
    /* Merges one piece of one copy, and makes the piece neutral again. */                         \
    VECTORISED static void drain_piece_##NAME(TYPE *restrict to, TYPE *restrict from,              \
                                              size_t count, redcc_word limit) {                    \
        (void)limit;                                                                               \
        for (size_t i = 0; i < count; i++) {                                                       \
            const TYPE b = to[i], x = from[i];                                                     \
            to[i] = COMBINED;                                                                      \
            from[i] = NEUTRAL;                                                                     \
        }                                                                                          \
    }                                                                                              \
    static void drain_##NAME(void *to, void *const *from, size_t copies, size_t count,             \
                             redcc_word limit) {                                                   \
        for (size_t begin = 0; begin < count; begin += PIECE) {                                    \
            const size_t piece = count - begin < PIECE ? count - begin : PIECE;                    \
            for (size_t copy = 0; copy < copies; copy++)                                           \
                drain_piece_##NAME((TYPE *)to + begin, (TYPE *)from[copy] + begin, piece, limit);  \
        }                                                                                          \
    }
#define DEFINE_APPLY(NAME, TYPE, NEUTRAL, IS_NEUTRAL, COMBINED)                                    \
    ALWAYS_INLINE void apply_rows_##NAME(const redcc_applied *applied, size_t count) {             \
        TYPE *const rows = applied->rows[0];                                                       \
        const TYPE *const records = applied->records;                                              \
        for (size_t k = 0; k < applied->count; k++) {                                              \
            TYPE *const row = &rows[applied->place[k] * count];                                    \
            if (applied->ahead)                                                                    \
                __builtin_prefetch(&rows[applied->place[k + applied->ahead] * count], 1);          \
            for (size_t i = 0; i < count; i++) {                                                   \
                TYPE *const to = &row[i];                                                          \
                const TYPE b = *to, x = records[k * count + i];                                    \
                if (count == 1 || !(IS_NEUTRAL)) /* neutral: it may not have been updated */       \
                    *to = COMBINED;                                                                \
            }                                                                                      \
        }                                                                                          \
    }                                                                                              \
    static void apply_##NAME(const redcc_applied *applied, size_t count) {                         \
        if (count == 1)                                                                            \
            apply_rows_##NAME(applied, 1);                                                         \
        else if (count == 3)                                                                       \
            apply_rows_##NAME(applied, 3);                                                         \
        else                                                                                       \
            apply_rows_##NAME(applied, count);                                                     \
    }
ALL_RULES(DEFINE)
ALL_INTEGERS(COUNTER_RULES, DEFINE)
ALL_RULES(DEFINE_APPLY)

enum { OPERATORS = REDCC_XOR + 1, NUMBERED = OPERATORS * (REDCC_OTHER_TYPE + 1) };

/* Enumerators such as PAIR_DOUBLE_SUM for each pair of type and operator. */
#define PAIRS(T)                                                                                   \
    PAIR_##T##_SUM = REDCC_##T * OPERATORS + REDCC_SUM,                                            \
    PAIR_##T##_PRODUCT = REDCC_##T * OPERATORS + REDCC_PRODUCT,                                    \
    PAIR_##T##_MINIMUM = REDCC_##T * OPERATORS + REDCC_MINIMUM,                                    \
    PAIR_##T##_MAXIMUM = REDCC_##T * OPERATORS + REDCC_MAXIMUM,                                    \
    PAIR_##T##_SATURATING = REDCC_##T * OPERATORS + REDCC_SATURATING,                              \
    PAIR_##T##_AND = REDCC_##T * OPERATORS + REDCC_AND,                                            \
    PAIR_##T##_OR = REDCC_##T * OPERATORS + REDCC_OR,                                              \
    PAIR_##T##_XOR = REDCC_##T * OPERATORS + REDCC_XOR
enum {
    PAIRS(INT8),
    PAIRS(UINT8),
    PAIRS(INT16),
    PAIRS(UINT16),
    PAIRS(INT32),
    PAIRS(UINT32),
    PAIRS(INT64),
    PAIRS(UINT64),
    PAIRS(FLOAT),
    PAIRS(DOUBLE),
    PAIRS(LONG_DOUBLE),
    PAIRS(FLOAT_COMPLEX),
    PAIRS(DOUBLE_COMPLEX)
};

#define ENTRY(NAME, TYPE, NEUTRAL, IS_NEUTRAL, COMBINED)                                           \
    [PAIR_##NAME] = {sizeof(TYPE),     fill_##NAME,  merge_##NAME,                                 \
                     merge_all_##NAME, drain_##NAME, apply_##NAME},
#define COUNTER_ENTRY(NAME, TYPE, NEUTRAL, IS_NEUTRAL, COMBINED)                                   \
    [PAIR_##NAME] = {sizeof(TYPE), fill_##NAME, merge_##NAME, merge_all_##NAME, drain_##NAME, NULL},
static const struct element_rule rules[NUMBERED] = {ALL_RULES(ENTRY)
                                                        ALL_INTEGERS(COUNTER_RULES, COUNTER_ENTRY)};

const struct element_rule *redcc_element_rule(redcc_operator operation, redcc_type type) {
    if ((unsigned)type >= REDCC_OTHER_TYPE || (unsigned)operation >= OPERATORS)
        return NULL;
    const struct element_rule *rule = &rules[(int)type * OPERATORS + (int)operation];
    return rule->size ? rule : NULL;
}
