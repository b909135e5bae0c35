/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* What REDCC_ORDER promises, on numbers that are hard to sum, with 1 to 64 threads, by the method
 * that REDCC_METHOD names. `serial`: the sequential loop's bits. `fixed`: the same bits with all
 * thread counts. `any`: within the error bound of a sum in any order. Exact sums are computed with
 * 113 bits. REDCC_SUM=compensated: the bits of each element's sum by Neumaier's algorithm, in the
 * loop's order. */
#include "loop.h"
#include "problem.h"
#include "settings.h"

#include <float.h>
#include <math.h>
#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#if defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 wide;
#else
typedef long double wide;
#endif

static const int thread_counts[] = {1, 2, 3, 7, 16, 33, 64};
enum { COUNTS = sizeof thread_counts / sizeof *thread_counts };

/* Returns the order of the results: the named method's, or for auto the requested one. */
static redcc_order promised(void) {
    const struct settings *settings = redcc_settings();
    if (settings->method)
        return settings->method->keeps;
    return settings->order_given ? settings->order : REDCC_ORDER_SERIAL;
}

static double between(unsigned long *random, double low, double high) {
    return low + (high - low) * (double)(next_random(random) >> 11) * 0x1p-53;
}

/* Returns contribution number `at`. Bodies multiply contributions by small integers. */
typedef double maker(long at, unsigned long *random);

/* Large numbers of both signs, whose sum is about 1e-16 of their magnitude. */
static double cancelling(long at, unsigned long *random) {
    static double last;
    last = at % 2 ? 1e-3 * between(random, 0, 1) - last : between(random, 1e12, 1e13);
    return last;
}

static double of_all_magnitudes(long at, unsigned long *random) {
    const double size = pow(10, between(random, -300, 300));
    return at % 3 ? size : -size;
}

static double subnormal(long at, unsigned long *random) {
    return (at % 2 ? 1 : -1) * between(random, 0, 1) * DBL_MIN;
}

static double infinite_at_times(long at, unsigned long *random) {
    const unsigned long which = next_random(random) % 500;
    if (which < 2)
        return at % 2 ? INFINITY : -INFINITY;
    return which == 2 ? NAN : between(random, -1, 1);
}

static double minus_zero(long at, unsigned long *random) {
    (void)at;
    (void)random;
    return -0.0;
}

static double ordinary(long at, unsigned long *random) {
    (void)at;
    return between(random, -1, 1);
}

/* An element's exact sum, the sum of absolute values, and the number of terms. */
struct exact {
    wide sum;
    wide size;
    long count;
};

static void add_exactly(struct exact *exact, double value) {
    exact->sum += (wide)value;
    exact->size += value < 0 ? -(wide)value : (wide)value;
    exact->count++;
}

static void sum_exactly(const struct problem *problem, struct exact *exact) {
    for (long i = 0; i < problem->doubles; i++) {
        exact[i] = (struct exact){0, 0, 0};
        add_exactly(&exact[i], problem->first[i]);
    }
    for (long k = 0; k < problem->touches; k++)
        for (int c = 0; c < problem->width; c++)
            add_exactly(&exact[(long)problem->row[k] * problem->width + c],
                        problem->value[k] * (c + 1));
}

/* Neumaier's algorithm in its original form, with the branch that the runtime's TwoSum avoids. */
static void sum_compensated(struct problem *problem, const struct exact *exact) {
    double *lost = calloc((size_t)problem->doubles, sizeof *lost);
    for (long k = 0; k < problem->touches; k++)
        for (int c = 0; c < problem->width; c++) {
            const long at = (long)problem->row[k] * problem->width + c;
            const double value = problem->value[k] * (c + 1), sum = problem->first[at];
            problem->first[at] = sum + value;
            lost[at] += fabs(sum) >= fabs(value) ? (sum - problem->first[at]) + value
                                                 : (value - problem->first[at]) + sum;
        }
    for (long at = 0; at < problem->doubles; at++) {
        if (lost[at] != 0 && isfinite(lost[at]))
            problem->first[at] += lost[at];
        const wide n_u = (wide)exact[at].count * (wide)(DBL_EPSILON / 2);
        const wide sum = exact[at].sum, off = (wide)problem->first[at] - sum;
        if (isfinite((double)sum)) /* the error bound of Neumaier's algorithm */
            assert_true((off < 0 ? -off : off) <= (wide)DBL_EPSILON * (sum < 0 ? -sum : sum) +
                                                      2 * n_u * n_u * exact[at].size);
    }
    free(lost);
}

static bool same_bits(double a, double b) {
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

/* Is `found` within the error bound of n additions in any order? The bound is |found - sum| <= n u
 * / (1 - n u) times the sum of the absolute values, where u is the unit roundoff (Higham, Accuracy
 * and Stability of Numerical Algorithms, section 4.2). */
static bool explained(double found, struct exact exact) {
    const double sum = (double)exact.sum;
    if (!isfinite(sum))
        return same_bits(found, sum);
    const wide n_u = (wide)exact.count * (wide)(DBL_EPSILON / 2);
    const wide off = (wide)found - exact.sum;
    return (off < 0 ? -off : off) <= n_u / (1 - n_u) * exact.size;
}

static bool acceptable(const struct problem *problem, long i, const double *serial,
                       const double *first_found, const struct exact *exact) {
    const double found = problem->first[i];
    switch (promised()) {
    case REDCC_ORDER_SERIAL:
        return same_bits(found, serial[i]);
    case REDCC_ORDER_FIXED:
        return same_bits(found, first_found[i]) && explained(found, exact[i]);
    case REDCC_ORDER_ANY:
        break;
    }
    return explained(found, exact[i]);
}

static void fill(struct problem *problem, maker *contribution) {
    unsigned long random = 362436069;
    for (long k = 0; k < problem->touches; k++)
        problem->value[k] = contribution(k, &random);
}

static void begin_with(struct problem *problem, double value) {
    for (long i = 0; i < problem->doubles; i++)
        problem->first[i] = value;
}

static void at_all_thread_counts(int number, maker *contribution, double before) {
    struct problem problem = problem_new(number, false);
    const size_t count = (size_t)problem.doubles;
    double *serial = malloc(count * sizeof *serial), *found = malloc(count * sizeof *found);
    struct exact *exact = malloc(count * sizeof *exact);
    fill(&problem, contribution);
    begin_with(&problem, before);
    sum_exactly(&problem, exact);
    if (redcc_settings()->compensated)
        sum_compensated(&problem, exact);
    else
        problem_oracle(&problem);
    memcpy(serial, problem.first, count * sizeof *serial);
    const int runs = promised() == REDCC_ORDER_ANY ? 1 : 2;
    for (int i = 0; i < COUNTS; i++) {
        if (promised() == REDCC_ORDER_ANY && thread_counts[i] == 33)
            continue; /* DWA-LIP would have hundreds of stages and test nothing new */
        struct described described;
        problem_describe(&problem, &described);
        if (!redcc_settings()->method)
            described.loop.order = promised();
        for (int run = 0; run < runs; run++) {
            long last;
            begin_with(&problem, before);
            problem_run(&problem, &described, thread_counts[i], &last);
            if (i == 0 && run == 0)
                memcpy(found, problem.first, count * sizeof *found);
            for (long e = 0; e < problem.doubles; e++)
                if (!acceptable(&problem, e, serial, found, exact))
                    fail_msg("%s, %d threads, run %d, element %ld: %a; serial %a, first found %a",
                             problem.name, thread_counts[i], run, e, problem.first[e], serial[e],
                             found[e]);
        }
        redcc_loop_forget(&described.loop);
    }
    problem_free(&problem);
    free(serial);
    free(found);
    free(exact);
}

/* Numbers of the problems in problem.c that have one array. */
enum { SORTED = 0, SHUFFLED = 1, ROWS = 2, CONTENTION = 4, ONE_ITERATION = 5, ONE_ELEMENT = 6 };

static void cancellation(void **unused) {
    (void)unused;
    at_all_thread_counts(SORTED, cancelling, 0);
    at_all_thread_counts(SHUFFLED, cancelling, 0);
    at_all_thread_counts(CONTENTION, cancelling, 0);
}

static void all_magnitudes(void **unused) {
    (void)unused;
    at_all_thread_counts(ROWS, of_all_magnitudes, 1e-300);
    at_all_thread_counts(SHUFFLED, of_all_magnitudes, 1);
}

static void subnormals(void **unused) {
    (void)unused;
    at_all_thread_counts(SORTED, subnormal, 0);
    at_all_thread_counts(ONE_ELEMENT, subnormal, DBL_MIN);
}

static void infinities_and_nan(void **unused) {
    (void)unused;
    at_all_thread_counts(ROWS, infinite_at_times, 0);
    at_all_thread_counts(SHUFFLED, infinite_at_times, 0);
}

static void minus_zero_stays(void **unused) {
    (void)unused;
    struct problem problem = problem_new(SHUFFLED, false);
    fill(&problem, minus_zero);
    for (int i = 0; i < COUNTS; i++) {
        struct described described;
        long last;
        problem_describe(&problem, &described);
        begin_with(&problem, -0.0);
        problem_run(&problem, &described, thread_counts[i], &last);
        for (long e = 0; e < problem.doubles; e++)
            assert_true(problem.first[e] == 0 && signbit(problem.first[e]));
        begin_with(&problem, 0.0);
        problem_run(&problem, &described, thread_counts[i], &last);
        for (long e = 0; e < problem.doubles; e++)
            assert_true(problem.first[e] == 0 && !signbit(problem.first[e]));
        redcc_loop_forget(&described.loop);
    }
    problem_free(&problem);
}

static void contention_and_the_smallest(void **unused) {
    (void)unused;
    at_all_thread_counts(CONTENTION, ordinary, 0.1);
    at_all_thread_counts(ONE_ELEMENT, ordinary, 0.1);
    at_all_thread_counts(ONE_ITERATION, ordinary, 0.1);
}

/* Other element types: TRIP contributions VALUE(t) are added to element row[t] of BINS. */
enum { TRIP = 6000, BINS = 40 };
static int row[TRIP];

/* Each iteration touches one row of `bytes` bytes. */
static void classify(redcc_worker *worker, const void *array, size_t bytes) {
    unsigned char class[REDCC_SELECTED];
    for (redcc_int t = worker->first; t < worker->last; t++) {
        redcc_probe probe = {0, 0, 1, 0, 0, 0, 0, 0};
        redcc_probe_touch_row(&probe, worker, 0, array, row[t], bytes);
        class[t - worker->first] = redcc_class_of(&probe);
    }
    redcc_store_classes(worker, class, worker->last);
}

#define KERNEL(NAME, T, OPERATION, TYPE, UPDATE)                                                   \
    static void NAME(redcc_loop *loop, T *array, int threads) {                                    \
        void *const bases[] = {array};                                                             \
        const redcc_extent known[] = {{(const char *)row, (const char *)(row + TRIP)}};            \
        const redcc_array arrays[] = {{"array", OPERATION, TYPE, sizeof(T), sizeof(T), 0}};        \
        const redcc_source sources[] = {{"row", 1}};                                               \
        redcc_call call;                                                                           \
        *loop = (redcc_loop){                                                                      \
            __FILE__, 1,       #NAME, promised(), REDCC_VERIFIABLE | REDCC_SELECTS, 1, arrays,     \
            1,        sources, 0,     0};                                                          \
        if (redcc_enter(&call, loop, TRIP, bases, known, 0, threads, 0)) {                         \
            _Pragma("omp parallel num_threads(call.threads)") {                                    \
                redcc_worker worker;                                                               \
                redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());           \
                while (redcc_inspect(&worker))                                                     \
                    for (redcc_int t = worker.first; t < worker.last; t += worker.stride) {        \
                        redcc_touch(&worker, 0, &array[row[t]], sizeof array[0]);                  \
                        redcc_iteration_done(&worker);                                             \
                    }                                                                              \
                for (int asked; (asked = redcc_next(&worker)) != 0;) {                             \
                    if (asked == REDCC_SELECT) {                                                   \
                        classify(&worker, array, sizeof(T));                                       \
                        continue;                                                                  \
                    }                                                                              \
                    T *const to = worker.base[0];                                                  \
                    for (const redcc_iterations *run = worker.run; run != worker.run_end; run++) { \
                        int t = (int)(worker.origin + run->begin);                                 \
                        const int end = t + (int)(run->count_and_check / 2);                       \
                        for (; t < end; t++)                                                       \
                            if (!(run->count_and_check & 1) ||                                     \
                                redcc_owns(&worker.owner[0], &to[row[t]])) {                       \
                                T *const b = &to[row[t]];                                          \
                                UPDATE;                                                            \
                            }                                                                      \
                    }                                                                              \
                }                                                                                  \
            }                                                                                      \
        }                                                                                          \
        if (!redcc_leave(&call))                                                                   \
            for (int t = 0; t < TRIP; t++) {                                                       \
                T *const b = &array[row[t]];                                                       \
                UPDATE;                                                                            \
            }                                                                                      \
        redcc_loop_forget(loop);                                                                   \
    }

#define NOT_A_NUMBER(t) ((t) % 11 == 3 ? (double)NAN : (double)((t)*37 % 101))
KERNEL(count_in_floats, float, REDCC_SUM, REDCC_FLOAT, *b += 1)
KERNEL(add_wrapping, uint32_t, REDCC_SUM, REDCC_UINT32, *b += 4000000000u + (uint32_t)t)
KERNEL(add_in_bytes, int8_t, REDCC_SUM, REDCC_INT8, *b = (int8_t)(*b + 100))
KERNEL(least, double, REDCC_MINIMUM, REDCC_DOUBLE, if (NOT_A_NUMBER(t) < *b) *b = NOT_A_NUMBER(t))
KERNEL(most, double, REDCC_MAXIMUM, REDCC_DOUBLE, *b = NOT_A_NUMBER(t) > *b ? NOT_A_NUMBER(t) : *b)

static void fill_rows(void) {
    unsigned long random = 521288629;
    for (int t = 0; t < TRIP; t++)
        row[t] = (int)(next_random(&random) % BINS);
}

/* A float counter stops at 2^24, where the sequential loop's counter does. In other orders it may
 * continue. */
static void float_counters_past_2_to_24(void **unused) {
    (void)unused;
    float first[BINS] = {0};
    fill_rows();
    for (int i = 0; i < COUNTS; i++) {
        float found[BINS];
        redcc_loop loop;
        for (int e = 0; e < BINS; e++)
            found[e] = 0x1p24f - 50;
        count_in_floats(&loop, found, thread_counts[i]);
        if (i == 0)
            memcpy(first, found, sizeof first);
        for (int e = 0; e < BINS; e++) {
            int count = 0;
            for (int t = 0; t < TRIP; t++)
                count += row[t] == e;
            if (redcc_settings()->compensated)
                assert_true(found[e] == (float)((1 << 24) - 50 + count));
            else if (promised() == REDCC_ORDER_SERIAL)
                assert_true(found[e] == 0x1p24f);
            else
                assert_true(found[e] >= 0x1p24f && found[e] <= 0x1p24f + (float)TRIP);
            if (promised() == REDCC_ORDER_FIXED)
                assert_true(found[e] == first[e]);
        }
    }
}

static void integers_wrap_around(void **unused) {
    (void)unused;
    uint32_t sums[BINS] = {0};
    int8_t bytes[BINS] = {0};
    fill_rows();
    for (int t = 0; t < TRIP; t++) {
        sums[row[t]] += 4000000000u + (uint32_t)t;
        bytes[row[t]] = (int8_t)(bytes[row[t]] + 100);
    }
    for (int i = 0; i < COUNTS; i++) {
        uint32_t found_sums[BINS] = {0};
        int8_t found_bytes[BINS] = {0};
        redcc_loop loop;
        add_wrapping(&loop, found_sums, thread_counts[i]);
        add_in_bytes(&loop, found_bytes, thread_counts[i]);
        assert_memory_equal(sums, found_sums, sizeof sums);
        assert_memory_equal(bytes, found_bytes, sizeof bytes);
    }
}

/* Comparisons with NaN are false: a NaN is never stored, and an initial NaN remains. */
static void minimum_and_maximum_with_nan(void **unused) {
    (void)unused;
    double expected[2][BINS], found[2][BINS];
    fill_rows();
    for (int i = -1; i < COUNTS; i++) {
        double(*const b)[BINS] = i < 0 ? expected : found;
        for (int e = 0; e < BINS; e++) {
            b[0][e] = e % 5 == 2 ? (double)NAN : 1e9;
            b[1][e] = e % 5 == 2 ? (double)NAN : -1e9;
        }
        redcc_loop loop;
        for (int t = 0; i < 0 && t < TRIP; t++) {
            const double value = NOT_A_NUMBER(t);
            b[0][row[t]] = value < b[0][row[t]] ? value : b[0][row[t]];
            b[1][row[t]] = value > b[1][row[t]] ? value : b[1][row[t]];
        }
        if (i >= 0) {
            least(&loop, b[0], thread_counts[i]);
            most(&loop, b[1], thread_counts[i]);
            assert_memory_equal(expected, found, sizeof expected);
        }
    }
}

/* Functions that update a whole row or a part of it, after one owner check. */
typedef double triple[3];

static void add_row(double *to, int t) {
    to[0] += 1e8 / (t + 1.0);
    to[1] -= 1.0 / (t + 3.0);
    to[2] += 1e-9 * t;
}

static void add_last_two(double *to, int t) {
    to[0] += 0.1 * t;
    to[1] += 1.0 / (t + 7.0);
}

#define THREE_UPDATES(ROW, OWNS)                                                                   \
    if (OWNS(&(ROW)[0]))                                                                           \
        add_row((ROW), t);                                                                         \
    if (OWNS(&(ROW)[1]))                                                                           \
        add_last_two(&(ROW)[1], t);                                                                \
    if (OWNS(&(ROW)[0]))                                                                           \
    (ROW)[0] += 0.3

#define ALWAYS(address) 1
#define OWNED(address) redcc_owns(&own, address)

static void rows_by_functions(triple *array, int threads) {
    void *const bases[] = {array};
    const redcc_extent known[] = {{(const char *)row, (const char *)(row + TRIP)}};
    static const redcc_array arrays[] = {
        {"array", REDCC_SUM, REDCC_DOUBLE, sizeof(double), sizeof(triple), 0}};
    static const redcc_source sources[] = {{"row", 1}};
    redcc_loop loop = {.file = __FILE__,
                       .line = 1,
                       .function = __func__,
                       .order = promised(),
                       .flags = REDCC_VERIFIABLE | REDCC_SELECTS,
                       .array_count = 1,
                       .arrays = arrays,
                       .source_count = 1,
                       .sources = sources};
    redcc_call call;
    if (redcc_enter(&call, &loop, TRIP, bases, known, NULL, threads, 0)) {
#pragma omp parallel num_threads(call.threads)
        {
            redcc_worker worker;
            redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
            while (redcc_inspect(&worker))
                for (redcc_int t = worker.first; t < worker.last; t += worker.stride) {
                    redcc_touch(&worker, 0, &array[row[t]], sizeof array[0]);
                    redcc_iteration_done(&worker);
                }
            for (int asked; (asked = redcc_next(&worker)) != 0;) {
                if (asked == REDCC_SELECT) {
                    classify(&worker, array, sizeof array[0]);
                    continue;
                }
                triple *const to = worker.base[0];
                const redcc_owner own = worker.owner[0];
                for (const redcc_iterations *run = worker.run; run != worker.run_end; run++) {
                    int t = (int)(worker.origin + run->begin);
                    const int end = t + (int)(run->count_and_check / 2);
                    for (; t < end; t++)
                        if (run->count_and_check & 1) {
                            THREE_UPDATES(to[row[t]], OWNED);
                        } else {
                            THREE_UPDATES(to[row[t]], ALWAYS);
                        }
                }
            }
        }
    }
    if (!redcc_leave(&call))
        for (int t = 0; t < TRIP; t++) {
            THREE_UPDATES(array[row[t]], ALWAYS);
        }
    redcc_loop_forget(&loop);
}

/* Computes the sums of each row in long double (64 bits of precision or more), which count as
 * exact. */
static void sum_rows(long double (*sum)[3]) {
    for (int t = 0; t < TRIP; t++) {
        triple part = {0, 0, 0}, rest = {0.3, 0, 0};
        add_row(part, t);
        add_last_two(&rest[1], t);
        for (int c = 0; c < 3; c++)
            sum[row[t]][c] += (long double)part[c] + (long double)rest[c];
    }
}

static void rows_updated_by_functions(void **unused) {
    (void)unused;
    static long double exact[BINS][3];
    triple first[BINS];
    fill_rows();
    memset(exact, 0, sizeof exact);
    sum_rows(exact);
    for (int i = 0; i < COUNTS; i++) {
        triple found[BINS];
        memset(found, 0, sizeof found);
        rows_by_functions(found, thread_counts[i]);
        if (i == 0)
            memcpy(first, found, sizeof first);
        if (promised() != REDCC_ORDER_ANY)
            assert_memory_equal(first, found, sizeof first);
        for (int e = 0; e < 3 * BINS; e++) {
            const double sum = (double)exact[e / 3][e % 3];
            const double off = fabs(found[e / 3][e % 3] - sum) / (fabs(sum) * DBL_EPSILON);
            assert_true(off <= (redcc_settings()->compensated ? 1 : 500));
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cancellation),
        cmocka_unit_test(all_magnitudes),
        cmocka_unit_test(subnormals),
        cmocka_unit_test(infinities_and_nan),
        cmocka_unit_test(minus_zero_stays),
        cmocka_unit_test(contention_and_the_smallest),
        cmocka_unit_test(float_counters_past_2_to_24),
        cmocka_unit_test(integers_wrap_around),
        cmocka_unit_test(minimum_and_maximum_with_nan),
        cmocka_unit_test(rows_updated_by_functions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
