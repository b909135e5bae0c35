/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Stealable blocks: how they are cut, what they cost, which thread executes them, and when auto
 * uses them. The loop:
 *
 *     for (t = 0; t < trip; t++) { b[row[t]] += 1.0 / (t + 1); b[row[t] + 1] += 0.1 * t; } */
#include "base/memory.h"
#include "loop.h"
#include "ownership/cuts.h"
#include "ownership/estimate.h"
#include "plan/length.h"
#include "problem.h"
#include "settings.h"

#include <math.h>
#include <omp.h>
#include <sched.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { TRIP = 60000, EACH = 1 + REDCC_STEALABLE };

static int row[TRIP];
static double b[TRIP + 1], expected[TRIP + 1];
static char executed_by[TRIP][2]; /* number of times that threads 0 and 1 executed each iteration */

static const redcc_array array = {"b", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0};
static const redcc_source source = {"row", 1};
static redcc_loop loop = {.file = "test_stealing.c",
                          .line = 5,
                          .function = "execute",
                          .order = REDCC_ORDER_SERIAL,
                          .flags = REDCC_VERIFIABLE,
                          .array_count = 1,
                          .arrays = &array,
                          .source_count = 1,
                          .sources = &source};

#define BODY(t, MAY)                                                                               \
    if (MAY(&b[row[t]]))                                                                           \
        b[row[t]] += 1.0 / (double)((t) + 1);                                                      \
    if (MAY(&b[row[t] + 1]))                                                                       \
    b[row[t] + 1] += 0.1 * (double)(t)
#define ALWAYS(address) 1
#define OWN(address) redcc_owns(&own, address)

static void oracle(void) {
    memset(expected, 0, sizeof expected);
    for (int t = 0; t < TRIP; t++) {
        expected[row[t]] += 1.0 / (double)(t + 1);
        expected[row[t] + 1] += 0.1 * (double)t;
    }
}

/* Executes the loop. If `waits`, thread 1 waits in its first iteration until thread 0 has no work
 * left. */
static int execute(int threads, bool waits) {
    const redcc_extent known[] = {{(const char *)row, (const char *)(row + TRIP)}};
    void *const bases[] = {b};
    atomic_bool first_is_done = false;
    redcc_call call;
    redcc_loop_make(&loop); /* creates a state, although the loop is short */
    if (redcc_enter(&call, &loop, TRIP, bases, known, NULL, threads, omp_in_parallel())) {
#pragma omp parallel num_threads(call.threads)
        {
            redcc_worker worker;
            const int thread = omp_get_thread_num();
            redcc_join(&worker, &call, thread, omp_get_num_threads());
            while (redcc_inspect(&worker))
                for (redcc_int t = worker.first; t < worker.last; t += worker.stride) {
                    redcc_touch(&worker, 0, &b[row[t]], 8);
                    redcc_touch(&worker, 0, &b[row[t] + 1], 8);
                    redcc_iteration_done(&worker);
                }
            while (redcc_next(&worker)) {
                const redcc_owner own = worker.owner[0];
                while (waits && thread == 1 && !atomic_load(&first_is_done))
                    sched_yield();
                for (const redcc_iterations *run = worker.run; run != worker.run_end; run++) {
                    redcc_int t = worker.origin + run->begin;
                    const redcc_int end = t + run->count_and_check / 2;
                    const bool checked = run->count_and_check & 1;
                    for (; t < end; t++) {
                        if (thread < 2)
                            executed_by[t][thread]++;
                        if (checked) {
                            BODY(t, OWN);
                        } else {
                            BODY(t, ALWAYS);
                        }
                    }
                }
            }
            if (thread == 0)
                atomic_store(&first_is_done, true);
        }
    }
    const int done = redcc_leave(&call);
    for (int t = 0; !done && t < TRIP; t++) {
        BODY(t, ALWAYS);
    }
    redcc_sequential_done(&loop);
    return done;
}

static void sort_rows(void) {
    for (int t = 0; t < TRIP; t++)
        row[t] = t;
}

/* Makes each row occur in this many iterations. */
static void repeat_rows(int times) {
    for (int t = 0; t < TRIP; t++)
        row[t] = t / times;
}

static void begin(void) {
    memset(b, 0, sizeof b);
    memset(executed_by, 0, sizeof executed_by);
    oracle();
}

static int count_of(int thread) {
    int count = 0;
    for (int t = 0; t < TRIP; t++)
        count += executed_by[t][thread];
    return count;
}

/* The waiting thread executes only its own part, and the other thread executes all stealable
 * blocks. */
static void who_finishes_early_takes_the_stealable_blocks(void **unused) {
    (void)unused;
    if (!redcc_settings()->method)
        skip();
    sort_rows();
    for (int call = 0; call < 3; call++) {
        begin();
        assert_int_equal(execute(2, true), 1);
        assert_memory_equal(b, expected, sizeof b);
        assert_in_range(count_of(0), TRIP / 100 * 57, TRIP / 100 * 59);
        assert_in_range(count_of(1), TRIP / 100 * 41, TRIP / 100 * 43);
    }
    redcc_loop_forget(&loop);
    assert_int_equal(redcc_memory_live(), 0);
}

static void the_bits_are_those_of_the_loop(void **unused) {
    (void)unused;
    static const int counts[] = {2, 3, 7, 16, 33};
    if (!redcc_settings()->method)
        skip();
    for (int repeated = 0; repeated < 2; repeated++)
        for (int c = 0; c < 5; c++) {
            if (repeated)
                repeat_rows(600);
            else
                sort_rows();
            for (int call = 0; call < 2; call++) {
                begin();
                assert_int_equal(execute(counts[c], false), 1);
                assert_memory_equal(b, expected, sizeof b);
            }
            redcc_loop_forget(&loop);
        }
    assert_int_equal(redcc_memory_live(), 0);
}

static const struct method *method_by_auto(void) {
    const struct method *method = NULL;
    for (int call = 0; call < 8; call++) {
        begin();
        if (execute(2, false) == 0)
            problem_tell_slow(&loop, TRIP, 9e-8);
        assert_memory_equal(b, expected, sizeof b);
    }
    const struct loop_state *state = loop.state;
    if (state->cache.kept[0])
        method = state->cache.kept[0]->plan->method;
    redcc_loop_forget(&loop);
    return method;
}

static void auto_takes_them_where_they_cost_little(void **unused) {
    (void)unused;
    if (redcc_settings()->method)
        skip();
    sort_rows();
    assert_ptr_equal(method_by_auto(), &redcc_method_localwrite_steal);
}

/* Each row occurs in 600 iterations, 1 % of all, which a cut next to it replicates. */
static void auto_does_without_them_where_they_cost_more(void **unused) {
    (void)unused;
    if (redcc_settings()->method)
        skip();
    repeat_rows(600);
    assert_ptr_equal(method_by_auto(), &redcc_method_localwrite);
}

/* Takes the sample of one thread: iteration i touches b[i] and b[i + 1]. */
static void take_chain(struct sample *sample, int rows) {
    assert_true(redcc_sample_begin(sample, 4 * (size_t)rows, 0));
    for (int i = 0; i < rows; i++) {
        redcc_sample_add(sample, (uintptr_t)&b[i], 0, 1, 0);
        redcc_sample_add(sample, (uintptr_t)&b[i + 1], 0, 1, 0);
        redcc_sample_next_iteration(sample);
    }
}

static void stealable_blocks_are_small_and_joined_again(void **unused) {
    (void)unused;
    enum { ROWS = 10000, SHARES = 2 };
    static const int begins[] = {0, 4200, 4700, 5000, 9200, 9700};
    const redcc_loop one = {.arrays = &array, .array_count = 1};
    void *const bases[] = {b};
    struct partition partition;
    struct sample sample;
    struct estimate estimate;
    const struct sample *samples[] = {&sample};
    take_chain(&sample, ROWS);
    assert_true(redcc_partition_begin(&partition, &one, bases, SHARES * EACH));
    partition.stealable = REDCC_STEALABLE;
    assert_true(redcc_choose_cuts(&partition, samples, 1));
    for (uint32_t owner = 0; owner < SHARES * EACH; owner++) {
        const uintptr_t cut = redcc_cuts(&partition, 0)[owner];
        const int at = cut ? (int)((cut - (uintptr_t)b) / sizeof *b) : 0;
        assert_in_range(at + 2, begins[owner], begins[owner] + 4);
    }
    /* At each of five cuts one iteration is replicated. One cut exists without stealable blocks,
     * too, so four iterations are overhead. */
    assert_true(redcc_estimate(&partition, samples, 1, &estimate));
    const double overhead = estimate.overhead * (double)ROWS;
    assert_true(overhead > 3.9 && overhead < 4.1);
    assert_true(estimate.share > 0.499 && estimate.share < 0.501);
    /* before and after each replicated iteration the owners change; the shares at one cut only */
    assert_true(fabs(estimate.changes * (double)ROWS - 10) < 0.1);
    assert_true(fabs(estimate.share_changes * (double)ROWS - 2) < 0.1);
    const uintptr_t middle = redcc_cuts(&partition, 0)[EACH];
    redcc_partition_join_stealable(&partition);
    assert_int_equal(partition.owners, SHARES);
    assert_int_equal(partition.stealable, 0);
    assert_int_equal(redcc_cuts(&partition, 0)[0], 0);
    assert_int_equal(redcc_cuts(&partition, 0)[1], middle);
    assert_int_equal(redcc_cuts(&partition, 0)[2], UINTPTR_MAX);
    assert_true(redcc_estimate(&partition, samples, 1, &estimate));
    assert_true(estimate.overhead == 0);
    redcc_partition_end(&partition);
    redcc_sample_end(&sample);
    assert_int_equal(redcc_memory_live(), 0);
}

/* Each stealable schedule is claimed once, the larger ones first. The plan's length is that of the
 * most loaded thread. */
static void stealable_schedules_are_claimed_in_turn(void **unused) {
    (void)unused;
    static const uint32_t order[] = {1, 4, 7, 2, 5, 8, UINT32_MAX};
    static const redcc_int iterations[] = {100, 20, 5, 90, 20, 5, 10, 20, 5};
    struct schedule schedule[9] = {{0}};
    const struct plan plan = {.method = &redcc_method_localwrite_steal,
                              .threads = 3,
                              .teams = {.count = 1},
                              .schedule = schedule,
                              .schedules = 9};
    for (uint32_t claimed = 0; claimed < 7; claimed++)
        assert_int_equal(redcc_stealable_schedule(&plan, claimed), order[claimed]);
    for (int s = 0; s < 9; s++)
        schedule[s].iterations = iterations[s];
    /* thread 2 claims all stealable schedules: 10 + 20 + 20 + 20 + 5 + 5 + 5 = 85 */
    assert_int_equal(redcc_plan_length(&plan), 100);
    schedule[6].iterations = 60; /* loads of the claiming threads: 80, 100, 110, 105, 105, 110 */
    assert_int_equal(redcc_plan_length(&plan), 110);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stealable_blocks_are_small_and_joined_again),
        cmocka_unit_test(stealable_schedules_are_claimed_in_turn),
        cmocka_unit_test(who_finishes_early_takes_the_stealable_blocks),
        cmocka_unit_test(the_bits_are_those_of_the_loop),
        cmocka_unit_test(auto_takes_them_where_they_cost_little),
        cmocka_unit_test(auto_does_without_them_where_they_cost_more),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
