/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Every operator and type: the method named by REDCC_METHOD is compared with the sequential loop,
 * on values whose sums have the same bits in any order. */
#include "base/memory.h"
#include "loop.h"
#include "plan/elements.h"
#include "problem.h"

#include <complex.h>
#include <limits.h>
#include <math.h>
#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <cmocka.h>

enum {
    TRIP = 900,
    ROWS = 70,
    LIMIT = 14,
    GAP = 2 /* elements of a row that no iteration updates */
};

static int row[TRIP];

#define ADD(b, x) b = (__typeof__(b))(b + (x))
#define MULTIPLY(b, x) b = (__typeof__(b))(b * (x))
#define LEAST(b, x)                                                                                \
    if ((x) < b)                                                                                   \
    b = x
#define MOST(b, x)                                                                                 \
    if ((x) > b)                                                                                   \
    b = x
#define BELOW(b, x)                                                                                \
    if (b < (x))                                                                                   \
    b++
#define BITS_AND(b, x) b &= x
#define BITS_OR(b, x) b |= x
#define BITS_XOR(b, x) b ^= x

/* Contributions: small numbers, or for products mostly ones and few twos, so that nothing
 * overflows. */
#define SMALL(t) ((t)*37 % 19 - 9)
#define UNSIGNED(t) ((t)*37 % 19)
#define TWOS(t) ((t) % 300 == 7 ? 2 : 1)

#define WHOLE(X, NAME, T, PAIR, VALUE)                                                             \
    X(NAME##_sum, T, REDCC_SUM, PAIR, ADD, (T)(VALUE(t) / 3))                                      \
    X(NAME##_product, T, REDCC_PRODUCT, PAIR, MULTIPLY, (T)TWOS(t))                                \
    X(NAME##_minimum, T, REDCC_MINIMUM, PAIR, LEAST, (T)VALUE(t))                                  \
    X(NAME##_maximum, T, REDCC_MAXIMUM, PAIR, MOST, (T)VALUE(t))
#define COUNTER(X, NAME, T, PAIR) X(NAME##_saturating, T, REDCC_SATURATING, PAIR, BELOW, (T)LIMIT)
#define BITS(X, NAME, T, PAIR)                                                                     \
    X(NAME##_and, T, REDCC_AND, PAIR, BITS_AND, (T) ~(t % 8))                                      \
    X(NAME##_or, T, REDCC_OR, PAIR, BITS_OR, (T)(t % 16))                                          \
    X(NAME##_xor, T, REDCC_XOR, PAIR, BITS_XOR, (T)(t * 5))
#define ALL(X)                                                                                     \
    WHOLE(X, int8, int8_t, REDCC_INT8, SMALL)                                                      \
    BITS(X, int8, int8_t, REDCC_INT8)                                                              \
    COUNTER(X, int8, int8_t, REDCC_INT8)                                                           \
    WHOLE(X, uint8, uint8_t, REDCC_UINT8, UNSIGNED)                                                \
    BITS(X, uint8, uint8_t, REDCC_UINT8)                                                           \
    COUNTER(X, uint8, uint8_t, REDCC_UINT8)                                                        \
    WHOLE(X, int16, int16_t, REDCC_INT16, SMALL)                                                   \
    BITS(X, int16, int16_t, REDCC_INT16)                                                           \
    COUNTER(X, int16, int16_t, REDCC_INT16)                                                        \
    WHOLE(X, uint16, uint16_t, REDCC_UINT16, UNSIGNED)                                             \
    BITS(X, uint16, uint16_t, REDCC_UINT16)                                                        \
    COUNTER(X, uint16, uint16_t, REDCC_UINT16)                                                     \
    WHOLE(X, int32, int32_t, REDCC_INT32, SMALL)                                                   \
    BITS(X, int32, int32_t, REDCC_INT32)                                                           \
    COUNTER(X, int32, int32_t, REDCC_INT32)                                                        \
    WHOLE(X, uint32, uint32_t, REDCC_UINT32, UNSIGNED)                                             \
    BITS(X, uint32, uint32_t, REDCC_UINT32)                                                        \
    COUNTER(X, uint32, uint32_t, REDCC_UINT32)                                                     \
    WHOLE(X, int64, int64_t, REDCC_INT64, SMALL)                                                   \
    BITS(X, int64, int64_t, REDCC_INT64)                                                           \
    COUNTER(X, int64, int64_t, REDCC_INT64)                                                        \
    WHOLE(X, uint64, uint64_t, REDCC_UINT64, UNSIGNED)                                             \
    BITS(X, uint64, uint64_t, REDCC_UINT64)                                                        \
    COUNTER(X, uint64, uint64_t, REDCC_UINT64)                                                     \
    WHOLE(X, real_float, float, REDCC_FLOAT, SMALL)                                                \
    WHOLE(X, real_double, double, REDCC_DOUBLE, SMALL)                                             \
    WHOLE(X, real_long_double, long double, REDCC_LONG_DOUBLE, SMALL)                              \
    X(complex_float_sum, float complex, REDCC_SUM, REDCC_FLOAT_COMPLEX, ADD,                       \
      ((float)SMALL(t) + (float)(t % 5) * I))                                                      \
    X(complex_float_product, float complex, REDCC_PRODUCT, REDCC_FLOAT_COMPLEX, MULTIPLY, I)       \
    X(complex_double_sum, double complex, REDCC_SUM, REDCC_DOUBLE_COMPLEX, ADD,                    \
      ((double)SMALL(t) + (double)(t % 5) * I))                                                    \
    X(complex_double_product, double complex, REDCC_PRODUCT, REDCC_DOUBLE_COMPLEX, MULTIPLY, I)

/* A row consists of the element and GAP others, which have arbitrary bytes and must not change. */
#define KERNEL(NAME, T, OPERATION, TYPE, UPDATE, VALUE)                                            \
    static int run_##NAME(redcc_loop *loop, T(*array)[1 + GAP], int threads) {                     \
        void *const bases[] = {array};                                                             \
        const redcc_extent known[] = {{(const char *)row, (const char *)(row + TRIP)}};            \
        const redcc_word key[] = {1};                                                              \
        redcc_call call;                                                                           \
        if (redcc_enter(&call, loop, TRIP, bases, known, key, threads, 0)) {                       \
            _Pragma("omp parallel num_threads(call.threads)") {                                    \
                redcc_worker worker;                                                               \
                redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());           \
                while (redcc_inspect(&worker))                                                     \
                    for (redcc_int t = worker.first; t < worker.last; t += worker.stride) {        \
                        redcc_touch(&worker, 0, &array[row[t]], sizeof array[0]);                  \
                        redcc_iteration_done(&worker);                                             \
                    }                                                                              \
                while (redcc_next(&worker)) {                                                      \
                    T(*const b)[1 + GAP] = worker.base[0];                                         \
                    for (const redcc_iterations *run = worker.run; run != worker.run_end; run++) { \
                        int t = (int)(worker.origin + run->begin);                                 \
                        const int end = t + (int)(run->count_and_check / 2);                       \
                        for (; t < end; t++)                                                       \
                            if (!(run->count_and_check & 1) ||                                     \
                                redcc_owns(&worker.owner[0], &b[row[t]][0])) {                     \
                                UPDATE(b[row[t]][0], VALUE);                                       \
                            }                                                                      \
                    }                                                                              \
                }                                                                                  \
            }                                                                                      \
        }                                                                                          \
        return redcc_leave(&call);                                                                 \
    }                                                                                              \
    static void NAME(void **unused) {                                                              \
        (void)unused;                                                                              \
        static T expected[ROWS][1 + GAP], found[ROWS][1 + GAP];                                    \
        const redcc_array arrays[] = {                                                             \
            {#NAME, OPERATION, TYPE, sizeof(T), sizeof(T[1 + GAP]), LIMIT}};                       \
        const redcc_source sources[] = {{"row", 1}};                                               \
        for (int threads = 2; threads <= 5; threads += 3) {                                        \
            redcc_loop loop = {__FILE__,         1, #NAME,  REDCC_ORDER_SERIAL,                    \
                               REDCC_VERIFIABLE, 1, arrays, 1,                                     \
                               sources,          1, 0};                                            \
            memset(expected, 0xa5, sizeof expected);                                               \
            for (int i = 0; i < ROWS; i++)                                                         \
                expected[i][0] = (T)(i % 4);                                                       \
            memcpy(found, expected, sizeof found);                                                 \
            for (int call = 0; call < 2; call++) {                                                 \
                for (int t = 0; t < TRIP; t++) {                                                   \
                    UPDATE(expected[row[t]][0], VALUE);                                            \
                }                                                                                  \
                assert_true(run_##NAME(&loop, found, threads));                                    \
                for (int i = 0; i < ROWS; i++) {                                                   \
                    assert_true(expected[i][0] == found[i][0]);                                    \
                    assert_memory_equal(&expected[i][1], &found[i][1], GAP * sizeof(T));           \
                }                                                                                  \
            }                                                                                      \
            redcc_loop_forget(&loop);                                                              \
        }                                                                                          \
    }
ALL(KERNEL)

/* Merging a copy to which nothing was added must leave each element unchanged, bit for bit. */
static void neutral_elements_change_nothing(void **unused) {
    (void)unused;
    for (int type = 0; type < REDCC_OTHER_TYPE; type++)
        for (int operation = 0; operation <= REDCC_XOR; operation++) {
            const struct element_rule *rule =
                redcc_element_rule((redcc_operator)operation, (redcc_type)type);
            if (!rule)
                continue;
            _Alignas(64) unsigned char array[64 * 16], before[sizeof array], copy[sizeof array];
            unsigned long random = 5;
            for (size_t i = 0; i < sizeof array; i++)
                array[i] = before[i] = (unsigned char)next_random(&random);
            rule->fill(copy, sizeof array / rule->size);
            rule->merge(array, copy, sizeof array / rule->size, 0);
            assert_memory_equal(array, before, sizeof array);
            const void *copies[] = {copy, copy};
            rule->merge_all(array, copies, 2, sizeof array / rule->size, 0);
            assert_memory_equal(array, before, sizeof array);
        }
}

/* Copies that are drained piece by piece give the same bits as copies merged one after another, and
 * are neutral afterwards. The doubles are such that another order gives another sum. */
static void drained_copies_are_merged_in_order(void **unused) {
    (void)unused;
    enum { ELEMENTS = 2500, COPIES = 3 };
    static double array[ELEMENTS], expected[ELEMENTS], copy[COPIES][ELEMENTS];
    static double neutral[ELEMENTS];
    for (int operation = REDCC_SUM; operation <= REDCC_MAXIMUM; operation++) {
        const struct element_rule *rule =
            redcc_element_rule((redcc_operator)operation, REDCC_DOUBLE);
        void *const copies[] = {copy[0], copy[1], copy[2]};
        unsigned long random = 9;
        rule->fill(neutral, ELEMENTS);
        for (int i = 0; i < ELEMENTS; i++)
            array[i] = expected[i] = i % 7 ? (double)next_random(&random) / 3 : -0.0;
        for (int c = 0; c < COPIES; c++) {
            rule->fill(copy[c], ELEMENTS);
            for (int i = c; i < ELEMENTS; i += 2)
                copy[c][i] = (double)next_random(&random) * 1e-3;
            rule->merge(expected, copy[c], ELEMENTS, 0);
        }
        rule->drain(array, copies, COPIES, ELEMENTS, 0);
        assert_memory_equal(array, expected, sizeof array);
        for (int c = 0; c < COPIES; c++)
            assert_memory_equal(copy[c], neutral, sizeof neutral);
    }
}

/* Two threads increment elements that start at each possible value and stop at `limit`. */
#define STOPS_AT(NAME, T, TYPE, LOWEST, HIGHEST)                                                   \
    static void NAME##_stops_at(T limit) {                                                         \
        const struct element_rule *rule = redcc_element_rule(REDCC_SATURATING, TYPE);              \
        T copy[2];                                                                                 \
        rule->fill(copy, 2);                                                                       \
        for (int n = 0; n < 600; n++) {                                                            \
            const void *const copies[] = {&copy[0], &copy[1]};                                     \
            for (int value = LOWEST; value <= HIGHEST; value++) {                                  \
                T expected = (T)value, one = (T)value, all = (T)value;                             \
                for (int i = 0; i < n; i++) {                                                      \
                    BELOW(expected, limit);                                                        \
                }                                                                                  \
                rule->merge(&one, &copy[0], 1, (redcc_word)limit);                                 \
                rule->merge(&one, &copy[1], 1, (redcc_word)limit);                                 \
                rule->merge_all(&all, copies, 2, 1, (redcc_word)limit);                            \
                assert_int_equal(one, expected);                                                   \
                assert_int_equal(all, expected);                                                   \
            }                                                                                      \
            BELOW(copy[n % 3 == 0], limit);                                                        \
        }                                                                                          \
    }
STOPS_AT(uint8, uint8_t, REDCC_UINT8, 0, UINT8_MAX)
STOPS_AT(int8, int8_t, REDCC_INT8, INT8_MIN, INT8_MAX)

static void counters_stop_at_their_limit(void **unused) {
    (void)unused;
    uint8_stops_at(1);
    uint8_stops_at(100);
    uint8_stops_at(UINT8_MAX);
    int8_stops_at(1);
    int8_stops_at(INT8_MAX);
}

static void what_has_no_rule(void **unused) {
    (void)unused;
    assert_null(redcc_element_rule(REDCC_SUM, REDCC_OTHER_TYPE));
    assert_null(redcc_element_rule(REDCC_MINIMUM, REDCC_DOUBLE_COMPLEX));
    assert_null(redcc_element_rule(REDCC_XOR, REDCC_DOUBLE));
    assert_null(redcc_element_rule(REDCC_SATURATING, REDCC_DOUBLE));
    assert_non_null(redcc_element_rule(REDCC_XOR, REDCC_INT8));
}

/* -0.0 stays -0.0 if only -0.0 is added, and 0.0 stays 0.0. */
static void signed_zeros(void **unused) {
    (void)unused;
    const struct element_rule *rule = redcc_element_rule(REDCC_SUM, REDCC_DOUBLE);
    double array[2] = {-0.0, 0.0}, copy[2];
    const double expected[2] = {-0.0, 0.0};
    rule->fill(copy, 2);
    copy[0] += -0.0;
    copy[1] += -0.0;
    rule->merge(array, copy, 2, 0);
    assert_memory_equal(array, expected, sizeof array);
}

/* An iteration that finds no smaller value stores nothing: the page is read-only. */
static void a_minimum_stores_only_what_is_less(void **unused) {
    (void)unused;
    const void *page = mmap(NULL, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_ptr_not_equal(page, MAP_FAILED);
    const int more[2] = {5, 0}, less[2] = {-5, 0};
    const double above[2] = {0.5, NAN}, below[2] = {-0.5, -0.0};
    redcc_element_rule(REDCC_MINIMUM, REDCC_INT32)->merge((void *)page, more, 2, 0);
    redcc_element_rule(REDCC_MAXIMUM, REDCC_INT32)->merge((void *)page, less, 2, 0);
    redcc_element_rule(REDCC_MINIMUM, REDCC_DOUBLE)->merge((void *)page, above, 2, 0);
    redcc_element_rule(REDCC_MAXIMUM, REDCC_DOUBLE)->merge((void *)page, below, 2, 0);
    munmap((void *)page, 4096);
}

/* An iteration that finds a counter at its limit stores nothing either. */
static void a_counter_at_its_limit_is_not_stored(void **unused) {
    (void)unused;
    int *page = mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    const int counted[2] = {INT_MIN + 3, 9};
    assert_ptr_not_equal(page, MAP_FAILED);
    page[0] = 9;
    page[1] = 100;
    assert_int_equal(mprotect(page, 4096, PROT_READ), 0);
    redcc_element_rule(REDCC_SATURATING, REDCC_INT32)->merge(page, counted, 2, 9);
    munmap(page, 4096);
}

int main(void) {
    for (int t = 0; t < TRIP; t++)
        row[t] = (t * 31 + t / 7) % (ROWS - 3); /* the last rows are not touched */
    const struct CMUnitTest tests[] = {
#define TEST(NAME, T, OPERATION, TYPE, UPDATE, VALUE) cmocka_unit_test(NAME),
        ALL(TEST) cmocka_unit_test(neutral_elements_change_nothing),
        cmocka_unit_test(drained_copies_are_merged_in_order),
        cmocka_unit_test(what_has_no_rule),
        cmocka_unit_test(counters_stop_at_their_limit),
        cmocka_unit_test(signed_zeros),
        cmocka_unit_test(a_minimum_stores_only_what_is_less),
        cmocka_unit_test(a_counter_at_its_limit_is_not_stored),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
