/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Unit tests of the runtime's parts. */
#include "base/barrier.h"
#include "base/memory.h"
#include "ownership/cuts.h"
#include "ownership/sample.h"
#include "ownership/sweep.h"
#include "plan/length.h"
#include "plan/plan.h"
#include "problem.h"
#include "settings.h"

#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void nobody_passes_a_barrier_early(void **unused) {
    (void)unused;
    enum { THREADS = 33, ROUNDS = 50 };
    static struct barrier barrier;
    static int at[THREADS];
    int wrong = 0, alone = 0;
#pragma omp parallel num_threads(THREADS) reduction(+ : wrong, alone)
    {
        const int thread = omp_get_thread_num();
        for (int round = 1; round <= ROUNDS; round++) {
            at[thread] = round;
            if (redcc_barrier_arrive(&barrier, THREADS)) {
                alone++;
                redcc_barrier_release(&barrier);
            }
            for (int other = 0; other < THREADS; other++)
                wrong += at[other] != round;
            redcc_barrier_wait(&barrier, THREADS);
        }
    }
    assert_int_equal(wrong, 0);
    assert_int_equal(alone, ROUNDS);
}

static void sets_are_kept_once(void **unused) {
    (void)unused;
    struct sets sets;
    assert_true(redcc_sets_begin(&sets, 40));
    uint32_t number[780], again;
    for (uint32_t round = 0; round < 2; round++) {
        uint32_t count = 0;
        for (uint32_t a = 0; a < 40; a++)
            for (uint32_t b = a + 1; b < 40; b++, count++) {
                const uint32_t members[] = {a, b};
                assert_true(redcc_sets_intern(&sets, members, 2, &again));
                if (round == 0)
                    number[count] = again;
                assert_int_equal(number[count], again);
                assert_int_equal(redcc_set_minimum(&sets, again), a);
                assert_int_equal(redcc_set_maximum(&sets, again), b);
            }
    }
    assert_int_equal(sets.count, 1 + 40 + 780);
    redcc_sets_end(&sets);
    assert_int_equal(redcc_memory_live(), 0);
}

/* The sample of a loop with TOUCHES touches per iteration is thinned: one touch in `keep_each` is
 * kept. About as many touches of each array must remain in each of STRETCHES ranges of iterations.
 */
static void a_thinned_sample_is_even(void **unused) {
    (void)unused;
    enum { ITERATIONS = 20000, STRETCHES = 32, TOUCHES = 3 };
    for (uint64_t keep_each = 2; keep_each <= 32; keep_each *= 2) {
        struct sample sample;
        long count[STRETCHES][TOUCHES] = {{0}};
        assert_true(redcc_sample_begin(&sample, ITERATIONS * TOUCHES, 0));
        for (uint32_t i = 0; i < ITERATIONS; i++) {
            for (uint32_t touch = 0; touch < TOUCHES; touch++)
                redcc_sample_add(&sample, i, touch, 1, 0);
            redcc_sample_next_iteration(&sample);
        }
        redcc_sample_thin(&sample, keep_each);
        for (size_t i = 0; i < sample.count; i++)
            count[sample.item[i].iteration / (ITERATIONS / STRETCHES)][sample.item[i].array]++;
        const long expected = ITERATIONS / STRETCHES / (long)keep_each;
        for (int stretch = 0; stretch < STRETCHES; stretch++)
            for (int touch = 0; touch < TOUCHES; touch++)
                assert_in_range(count[stretch][touch], expected - 3, expected + 3);
        redcc_sample_end(&sample);
    }
}

/* Touches alternate between two arrays: both must be sampled from beginning to end. */
static void a_full_sample_stays_even(void **unused) {
    (void)unused;
    struct sample sample;
    size_t count[2][4] = {{0}};
    assert_true(redcc_sample_begin(&sample, 256, 0));
    for (uintptr_t i = 0; i < 20000; i++) {
        redcc_sample_add(&sample, i, i % 2, 1, 0);
        redcc_sample_next_iteration(&sample);
    }
    assert_in_range(sample.count, 96, 256);
    for (size_t i = 0; i < sample.count; i++)
        count[sample.item[i].array][sample.item[i].address / 5000]++;
    for (int array = 0; array < 2; array++)
        for (int quarter = 0; quarter < 4; quarter++)
            assert_in_range(count[array][quarter], sample.count / 16, sample.count / 4);
    redcc_sample_end(&sample);
}

/* Two arrays of a mesh: both must be cut at the same rows, and only between rows. */
static void cuts_of_several_arrays_lie_at_the_same_rows(void **unused) {
    (void)unused;
    enum { ROWS = 1000, OWNERS = 7 };
    static char b[ROWS * 24], a[ROWS * 72];
    const redcc_array arrays[] = {{"b", REDCC_SUM, REDCC_DOUBLE, 8, 24, 0},
                                  {"a", REDCC_SUM, REDCC_DOUBLE, 8, 72, 0}};
    const redcc_loop loop = {.arrays = arrays, .array_count = 2};
    void *const bases[] = {b, a};
    struct partition partition;
    struct sample sample;
    assert_true(redcc_partition_begin(&partition, &loop, bases, OWNERS));
    assert_true(redcc_sample_begin(&sample, 32768, 0));
    unsigned long random = 7;
    for (long t = 0; t < 3000; t++) {
        for (int node = 0; node < 3; node++) {
            const long row = (t / 3 + (long)(next_random(&random) % 5)) % ROWS;
            redcc_sample_add(&sample, (uintptr_t)&b[row * 24], 0, 1, 0);
            /* half of the matrix is stored: few touches in low rows, many in high ones */
            for (long block = 0; block < 1 + row / 100; block++)
                redcc_sample_add(&sample, (uintptr_t)&a[row * 72], 1, 1, 0);
        }
        redcc_sample_next_iteration(&sample);
    }
    const struct sample *samples[] = {&sample};
    assert_true(redcc_choose_cuts(&partition, samples, 1));
    for (int owner = 1; owner < OWNERS; owner++) {
        const long at_b = (long)(redcc_cuts(&partition, 0)[owner] - (uintptr_t)b);
        const long at_a = (long)(redcc_cuts(&partition, 1)[owner] - (uintptr_t)a);
        assert_int_equal(at_b % 24, 0);
        assert_int_equal(at_a % 72, 0);
        assert_in_range(at_b / 24, owner * ROWS / OWNERS - 20, owner * ROWS / OWNERS + 20);
        assert_in_range(at_a / 72 - at_b / 24 + 3, 0, 6);
    }
    redcc_sample_end(&sample);
    redcc_partition_end(&partition);
}

static void tell(struct sweep *sweep, const char *address, uint32_t bytes) {
    const redcc_entry entry = {address, 0, bytes};
    redcc_sweep_take(sweep, &entry, &entry + 1);
}

static void tell_end(struct sweep *sweep) {
    const redcc_entry entry = {0, REDCC_END_OF_ITERATION, 0};
    redcc_sweep_take(sweep, &entry, &entry + 1);
}

/* Iterations with one touch, with touches of several owners, with repeated owners, and without
 * touches. */
static void a_sweep_lists_each_owner_once(void **unused) {
    (void)unused;
    enum { OWNERS = 40 };
    static char b[OWNERS * 10];
    const redcc_array array = {"b", REDCC_SUM, REDCC_INT8, 1, 1, 0};
    const redcc_loop loop = {.arrays = &array, .array_count = 1};
    void *const bases[] = {b};
    struct partition partition;
    struct sweep sweep;
    struct range seen[] = {redcc_nowhere};
    assert_true(redcc_partition_begin(&partition, &loop, bases, OWNERS));
    for (uint32_t owner = 1; owner < OWNERS; owner++)
        redcc_cuts(&partition, 0)[owner] = (uintptr_t)&b[10 * owner];
    redcc_cuts(&partition, 0)[OWNERS] = UINTPTR_MAX;
    assert_true(redcc_sweep_begin(&sweep, &partition, seen));
    redcc_sweep_open_block(&sweep, 100);
    tell_end(&sweep);             /* 0: nothing */
    for (int i = 0; i < 3; i++) { /* 1 to 3: owners 5, 7 and 2 */
        tell(&sweep, &b[51], 1);
        tell(&sweep, &b[77], 2);
        tell(&sweep, &b[20 + i], 1);
        tell(&sweep, &b[50], 1);
        tell_end(&sweep);
    }
    tell(&sweep, &b[59], 2); /* 4: owners 5 and 6 by one touch */
    tell_end(&sweep);
    tell(&sweep, &b[60], 1); /* 5: owner 6 */
    tell_end(&sweep);
    tell(&sweep, b, sizeof b); /* 6: all */
    tell_end(&sweep);
    assert_true(redcc_sweep_close_block(&sweep, 7));
    const struct summary *summary = &sweep.summary;
    const struct sets *sets = &summary->sets;
    static const uint32_t first[] = {0, 2, 5, 6, 0}, size[] = {0, 3, 2, 1, OWNERS};
    static const uint32_t begin[] = {0, 1, 4, 5, 6};
    assert_int_equal(summary->span_count, 5);
    for (int s = 0; s < 5; s++) {
        const struct span span = summary->span[s];
        assert_int_equal(span.begin, begin[s]);
        assert_int_equal(redcc_set_size(sets, span.set), size[s]);
        if (size[s])
            assert_int_equal(redcc_set_minimum(sets, span.set), first[s]);
    }
    assert_int_equal(seen[0].first, (uintptr_t)b);
    assert_int_equal(seen[0].end, (uintptr_t)(b + sizeof b));
    redcc_sweep_end(&sweep);
    redcc_partition_end(&partition);
    assert_int_equal(redcc_memory_live(), 0);
}

/* A loop of 5 * 2^30 + 12 iterations. The first third touches owner 0, the middle third both, and
 * the last third owner 1. No memory is used per iteration. */
static void more_iterations_than_32_bits_count(void **unused) {
    (void)unused;
    const redcc_int third = (5ll << 30) / 3 + 4, trip = 3 * third;
    static const redcc_array array = {"b", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0};
    const redcc_loop loop = {.arrays = &array, .array_count = 1};
    double b[4];
    void *bases[] = {b};
    struct partition partition;
    struct summary summary[2];
    const struct summary *summaries[] = {&summary[0], &summary[1]};
    const struct range touched[] = {{(uintptr_t)b, (uintptr_t)(b + 4)}};
    const struct range *seen[] = {touched, touched};
    assert_true(redcc_partition_begin(&partition, &loop, bases, 2));
    redcc_cuts(&partition, 0)[1] = (uintptr_t)(b + 2);
    redcc_cuts(&partition, 0)[2] = UINTPTR_MAX;
    for (int thread = 0; thread < 2; thread++) {
        const uint32_t members[] = {0, 1};
        uint32_t both;
        assert_true(redcc_summary_begin(&summary[thread], 2));
        assert_true(redcc_sets_intern(&summary[thread].sets, members, 2, &both));
        redcc_int t = redcc_share(trip, 2, thread);
        const redcc_int end = redcc_share(trip, 2, thread + 1);
        while (t < end) {
            const redcc_int stop = end - t < REDCC_BLOCK ? end : t + REDCC_BLOCK;
            assert_true(redcc_summary_open_block(&summary[thread], t));
            while (t < stop) {
                const redcc_int limit = t < third ? third : t < 2 * third ? 2 * third : trip;
                const redcc_int next = limit < stop ? limit : stop;
                const uint32_t set = t < third ? 1 : t < 2 * third ? both : 2;
                assert_true(redcc_summary_add(&summary[thread], set, next - t));
                t = next;
            }
        }
    }
    const struct evidence evidence = {&partition, summaries, seen, 2, trip, NULL, false};
    static const struct method *const methods[] = {&redcc_method_localwrite,
                                                   &redcc_method_expansion, &redcc_method_dwa_lip};
    for (int m = 0; m < 3; m++) {
        struct plan *plan = redcc_plan_new(methods[m], 'b', 2, trip, &partition, touched, false);
        assert_non_null(plan);
        redcc_int visited = 0, highest = 0;
        for (int thread = 0; thread < 2; thread++) {
            assert_true(methods[m]->prepare(plan, &evidence, thread));
            const struct schedule *schedule = &plan->schedule[thread];
            assert_true(schedule->run_count <= 8);
            redcc_int before = 0;
            for (size_t c = 0; c < schedule->chunk_count; c++) {
                struct run_reader runs = redcc_runs_of(schedule, &schedule->chunk[c]);
                for (redcc_iterations run; redcc_runs_read(&runs, &run, 1) > 0;) {
                    const redcc_int begin = schedule->chunk[c].origin + run.begin;
                    const redcc_int count = run.count_and_check / 2;
                    assert_true(begin >= before);
                    before = begin + count;
                    visited += count;
                    if (m == 0) {
                        assert_true(begin >= thread * third && before <= (thread + 2) * third);
                        assert_int_equal(run.count_and_check & 1,
                                         begin >= third && before <= 2 * third);
                    }
                }
            }
            highest = before > highest ? before : highest;
        }
        assert_true(visited == (m == 0 ? 4 * third : trip));
        assert_true(highest == trip);
        redcc_plan_finish(plan);
        assert_true(plan->executed == visited);
        assert_int_equal(redcc_plan_stages(plan), m == 2 ? 2 : 1);
        assert_true(plan->length == (m == 1 ? (trip + 1) / 2 : 2 * third));
        redcc_plan_free(plan);
    }
    for (int thread = 0; thread < 2; thread++)
        redcc_summary_end(&summary[thread]);
    redcc_partition_end(&partition);
    assert_int_equal(redcc_memory_live(), 0);
}

/* Appends runs with gaps up to `gap` and counts up to `count`, some of them far larger, and checks
 * that they are read back. Each chunk is a stage, and some tasks go back to earlier iterations. */
static void expect_runs(redcc_int gap, redcc_int count, bool memory) {
    enum { RUNS = 5000 };
    static redcc_int begin[RUNS], length[RUNS];
    static bool checked[RUNS];
    struct schedule schedule = {0};
    unsigned long random = 88172645463325252u;
    redcc_int at = 0;
    for (int r = 0; r < RUNS; r++) {
        const bool far = next_random(&random) % 50 == 0;
        at += 1 + (redcc_int)(next_random(&random) % (unsigned long)gap) * (far ? 5000 : 1);
        if (r % 700 == 699)
            at -= 50; /* before the end of the preceding run, but not before the chunk's first
                         iteration */
        begin[r] = at;
        length[r] = 1 + (redcc_int)(next_random(&random) % (unsigned long)count) * (far ? 5000 : 1);
        checked[r] = next_random(&random) % 2;
        at += length[r];
        assert_true(
            redcc_schedule_add(&schedule, (uint32_t)r / 1000, begin[r], length[r], checked[r]));
    }
    const redcc_int iterations = schedule.iterations;
    redcc_memory_fail_after(memory ? -1 : 0);
    redcc_schedule_finish(&schedule);
    redcc_memory_fail_after(-1);
    assert_int_equal(schedule.packed != NULL, memory && gap < 1000);
    assert_true(schedule.iterations == iterations);
    int r = 0;
    for (size_t c = 0; c < schedule.chunk_count; c++) {
        struct run_reader reader = redcc_runs_of(&schedule, &schedule.chunk[c]);
        redcc_iterations run[7];
        for (size_t got; (got = redcc_runs_read(&reader, run, 1 + c % 7)) > 0;)
            for (size_t i = 0; i < got; i++, r++) {
                assert_int_equal(schedule.chunk[c].stage, r / 1000);
                assert_true(schedule.chunk[c].origin + run[i].begin == begin[r]);
                assert_true(run[i].count_and_check / 2 == length[r]);
                assert_int_equal(run[i].count_and_check & 1, checked[r]);
            }
    }
    assert_int_equal(r, RUNS);
    redcc_schedule_end(&schedule);
    assert_int_equal(redcc_memory_live(), 0);
}

static void packed_runs_are_the_runs(void **unused) {
    (void)unused;
    for (int memory = 0; memory < 2; memory++) {
        expect_runs(2, 2, memory);
        expect_runs(70, 30, memory);
        expect_runs(900, 1, memory);
        expect_runs(3000, 900, memory); /* too large for the packed form to save memory */
    }
}

/* Two threads with two tasks each. Each second task waits for the other thread's first task. */
static void a_plan_is_as_long_as_its_waits_make_it(void **unused) {
    (void)unused;
    static const redcc_int iterations[2][2] = {{10, 5}, {3, 20}};
    struct schedule schedule[2] = {{0}, {0}};
    uint32_t stages = 1;
    struct plan plan = {.method = &redcc_method_dwa_lip_fixed,
                        .threads = 2,
                        .teams = {1, &stages, NULL},
                        .owners = 2,
                        .schedule = schedule,
                        .flags = redcc_flags_new(4)};
    for (uint32_t thread = 0; thread < 2; thread++)
        for (uint32_t task = 0; task < 2; task++) {
            const uint32_t other = 1 - thread;
            assert_true(redcc_schedule_begin_task(&schedule[thread], &other, task));
            assert_true(redcc_schedule_add(&schedule[thread], 0, 100 * (redcc_int)task,
                                           iterations[thread][task], false));
            redcc_schedule_end_task(&schedule[thread], 2 * task + thread);
        }
    assert_int_equal(redcc_plan_length(&plan), 10 + 20);
    redcc_memory_fail_after(0);
    assert_int_equal(redcc_plan_length(&plan), 3 + 20);
    redcc_memory_fail_after(-1);
    for (int thread = 0; thread < 2; thread++)
        redcc_schedule_end(&schedule[thread]);
    redcc_memory_free(plan.flags);
    assert_int_equal(redcc_memory_live(), 0);
}

static void sizes(void **unused) {
    (void)unused;
    size_t bytes;
    assert_true(redcc_parse_bytes("17", &bytes) && bytes == 17);
    assert_true(redcc_parse_bytes("3K", &bytes) && bytes == 3 << 10);
    assert_true(redcc_parse_bytes("2M", &bytes) && bytes == 2 << 20);
    assert_true(redcc_parse_bytes("5G", &bytes) && bytes == 5ul << 30);
    static const char *const wrong[] = {
        "", "K", "-1", "1KB", "1k", "1 K", "99999999999999999999", "99999999999G"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_false(redcc_parse_bytes(wrong[i], &bytes));
}

/* An entry stores its number of bytes in 32 bits, so longer spans are split. */
static void spans_of_any_length(void **unused) {
    (void)unused;
    static const redcc_size longest = REDCC_LONGEST_TOUCH;
    const redcc_size lengths[] = {1,           longest - 1, longest,
                                  longest + 1, 5 * longest, 5 * longest + 7};
    const char *const first = (const char *)4096; /* any address; nothing is accessed */
    for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        redcc_entry entry[8];
        const redcc_owner nothing = {.first = NULL};
        redcc_worker worker = {.window = &nothing, .entry = entry, .entry_end = entry + 8};
        redcc_touch_span(&worker, 0, first, first + lengths[i]);
        const char *at = first;
        for (const redcc_entry *told = entry; told != worker.entry; told++) {
            assert_ptr_equal(told->address, at);
            at += told->bytes;
        }
        assert_ptr_equal(at, first + lengths[i]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nobody_passes_a_barrier_early),
        cmocka_unit_test(sets_are_kept_once),
        cmocka_unit_test(a_full_sample_stays_even),
        cmocka_unit_test(a_thinned_sample_is_even),
        cmocka_unit_test(cuts_of_several_arrays_lie_at_the_same_rows),
        cmocka_unit_test(a_sweep_lists_each_owner_once),
        cmocka_unit_test(more_iterations_than_32_bits_count),
        cmocka_unit_test(a_plan_is_as_long_as_its_waits_make_it),
        cmocka_unit_test(packed_runs_are_the_runs),
        cmocka_unit_test(sizes),
        cmocka_unit_test(spans_of_any_length),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
