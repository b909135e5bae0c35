/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Loops with more iterations than 31, 32 and 36 bits can count, by the method that REDCC_METHOD
 * names:
 *
 *     for (t = 0; t < trip; t++) {
 *         count[t / stretch] += 1;
 *         sum[t / stretch] += t;
 *     }
 *
 * For speed, equal iterations are recorded and executed all at once: the runtime hands them out in
 * runs and cannot notice this. With an argument they are recorded and executed one by one. */
#include "base/memory.h"
#include "loop.h"

#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { STRETCHES = 37 };

static int one_by_one;

struct tally {
    uint64_t count;
    uint64_t sum; /* sum of the iterations' numbers; wraps around */
};

static redcc_int least(redcc_int a, redcc_int b) {
    return a < b ? a : b;
}

/* Records iterations [first, end), all of which touch `element`. */
static void tell(redcc_worker *worker, struct tally *element, redcc_int first, redcc_int end) {
    while (first < end) {
        redcc_touch(worker, 0, element, sizeof *element);
        const int all_alike = worker->inside && !worker->outside && !one_by_one;
        redcc_iteration_done(worker);
        first++;
        if (all_alike) { /* has the effect of end - first calls of both functions */
            worker->alike += end - first;
            first = end;
        }
    }
}

/* Executes iterations [first, end), all of which update `element`. */
static void execute(struct tally *element, redcc_int first, redcc_int end) {
    if (one_by_one) {
        for (redcc_int t = first; t < end; t++) {
            element->count += 1;
            element->sum += (uint64_t)t;
        }
        return;
    }
    const uint64_t count = (uint64_t)(end - first), twice = (uint64_t)(first + end - 1);
    element->count += count;
    element->sum += count % 2 ? twice / 2 * count : count / 2 * twice;
}

/* Returns the element of iteration t. Sets *end to the first iteration with another element, if
 * that is less. */
static struct tally *element_of(struct tally *tally, redcc_int t, redcc_int stretch,
                                redcc_int *end) {
    *end = least(*end, (t / stretch + 1) * stretch);
    return &tally[t / stretch];
}

static int run_loop(redcc_loop *loop, struct tally *tally, redcc_int trip, redcc_int stretch,
                    int threads) {
    void *const bases[] = {tally};
    const redcc_word key[] = {(redcc_word)stretch};
    redcc_call call;
    if (redcc_enter(&call, loop, trip, bases, NULL, key, threads, 0)) {
#pragma omp parallel num_threads(call.threads)
        {
            redcc_worker worker;
            redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
            while (redcc_inspect(&worker))
                for (redcc_int t = worker.first, end; t < worker.last;) {
                    end = worker.stride == 1 ? worker.last : t + 1;
                    struct tally *const element = element_of(tally, t, stretch, &end);
                    tell(&worker, element, t, end);
                    t = worker.stride == 1 ? end : t + worker.stride;
                }
            while (redcc_next(&worker)) {
                struct tally *const to = worker.base[0];
                const redcc_owner own = worker.owner[0];
                for (const redcc_iterations *run = worker.run; run != worker.run_end; run++) {
                    redcc_int t = worker.origin + run->begin;
                    const redcc_int last = t + run->count_and_check / 2;
                    while (t < last) {
                        redcc_int end = last;
                        struct tally *const element = element_of(to, t, stretch, &end);
                        if (!(run->count_and_check & 1) || redcc_owns(&own, element))
                            execute(element, t, end);
                        t = end;
                    }
                }
            }
        }
    }
    return redcc_leave(&call);
}

/* Returns 0 + 1 + ... + (t - 1), modulo 2^64. */
static uint64_t sum_below(uint64_t t) {
    return t == 0 ? 0 : t % 2 ? t * ((t - 1) / 2) : t / 2 * (t - 1);
}

static void expect_all_iterations(redcc_int trip, int threads) {
    static const redcc_array arrays[] = {
        {"tally", REDCC_SUM, REDCC_UINT64, sizeof(uint64_t), sizeof(struct tally), 0}};
    redcc_loop loop = {.file = __FILE__,
                       .line = 1,
                       .function = "run_loop",
                       .order = REDCC_ORDER_SERIAL,
                       .flags = REDCC_VERIFIABLE,
                       .array_count = 1,
                       .arrays = arrays,
                       .key_count = 1};
    const redcc_int stretch = trip / (STRETCHES - 1);
    for (int call = 0; call < 2; call++) { /* with a new plan, then with the same one */
        struct tally found[STRETCHES], expected[STRETCHES];
        memset(found, 0, sizeof found);
        memset(expected, 0, sizeof expected);
        assert_int_equal(run_loop(&loop, found, trip, stretch, threads), 1);
        for (redcc_int t = 0, end; t < trip; t = end) {
            end = trip;
            struct tally *const element = element_of(expected, t, stretch, &end);
            element->count = (uint64_t)(end - t);
            element->sum = sum_below((uint64_t)end) - sum_below((uint64_t)t);
        }
        assert_memory_equal(found, expected, sizeof found);
    }
    redcc_loop_forget(&loop);
    assert_int_equal(redcc_memory_live(), 0);
}

static void more_than_31_bits(void **unused) {
    (void)unused;
    expect_all_iterations((redcc_int)(1LL << 31) + 3, 2);
    if (!one_by_one)
        expect_all_iterations((redcc_int)(1LL << 31) + 3, 5);
}

static void more_than_32_bits(void **unused) {
    (void)unused;
    if (one_by_one)
        skip();
    expect_all_iterations((redcc_int)(1LL << 32) + 5, 3);
    expect_all_iterations((redcc_int)(1LL << 36) + 11, 2);
}

int main(int count, char **arguments) {
    (void)arguments;
    one_by_one = count > 1;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(more_than_31_bits),
        cmocka_unit_test(more_than_32_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
