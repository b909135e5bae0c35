/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* An array whose elements are reached through pointers (its base is 0), with rows far apart in
 * memory: for (t) row[s[t]][t % WIDTH] += value[t], in the form that redcc generates. */
#include "base/memory.h"
#include "loop.h"
#include "problem.h"
#include "settings.h"

#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <cmocka.h>

enum { TRIP = 5000, ROWS = 60, WIDTH = 7, CALLS = 3 };

struct rows {
    double *row[ROWS];
    double *near, *far; /* [ROWS * WIDTH]; the memory between `near` and `far` is unreadable */
    int s[TRIP];
    double value[TRIP];
};

static const size_t used = ROWS * WIDTH * sizeof(double);
static const size_t room = 1 << 16, distance = (size_t)1 << 38;

static const redcc_array arrays[] = {
    {"rows", REDCC_SUM, REDCC_OTHER_TYPE, sizeof(double), sizeof(double), 0}};
static const redcc_source sources[] = {{"s", 1}, {"rows", 1}, {"value", 0}};

static redcc_loop new_loop(void) {
    return (redcc_loop){.file = "test_scattered.c",
                        .line = 3,
                        .function = "run",
                        .order = REDCC_ORDER_SERIAL,
                        .flags = REDCC_VERIFIABLE | REDCC_ORDER_NEEDED,
                        .array_count = 1,
                        .arrays = arrays,
                        .source_count = 3,
                        .sources = sources,
                        .key_count = 1};
}

static void oracle(struct rows *it) {
    for (int t = 0; t < TRIP; t++)
        it->row[it->s[t]][t % WIDTH] += it->value[t];
}

static void execute(const struct rows *it, redcc_worker *worker) {
    const redcc_owner own = worker->owner[0];
    for (const redcc_iterations *run = worker->run; run != worker->run_end; run++) {
        redcc_int t = worker->origin + run->begin;
        const redcc_int end = t + run->count_and_check / 2;
        for (; t < end; t++) {
            double *to = &it->row[it->s[t]][t % WIDTH];
            if (!(run->count_and_check & 1) || redcc_owns(&own, to))
                *to += it->value[t];
        }
    }
}

static bool run(struct rows *it, redcc_loop *loop, int threads) {
    void *const bases[] = {NULL};
    const redcc_extent known[] = {{(const char *)it->s, (const char *)(it->s + TRIP)},
                                  {(const char *)it->row, NULL},
                                  {(const char *)it->value, (const char *)(it->value + TRIP)}};
    const redcc_word key[] = {0};
    redcc_call call;
    if (redcc_enter(&call, loop, TRIP, bases, known, key, threads, omp_in_parallel())) {
#pragma omp parallel num_threads(call.threads)
        {
            redcc_worker worker;
            redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
            while (redcc_inspect(&worker))
                for (redcc_int t = worker.first; t < worker.last; t += worker.stride) {
                    redcc_read(&worker, 1, &it->row[it->s[t]], sizeof it->row[0]);
                    redcc_touch(&worker, 0, &it->row[it->s[t]][t % WIDTH], sizeof(double));
                    redcc_iteration_done(&worker);
                }
            while (redcc_next(&worker))
                execute(it, &worker);
        }
    }
    const bool done = redcc_leave(&call);
    if (!done)
        oracle(it);
    redcc_sequential_done(loop);
    return done;
}

static struct rows *new_rows(bool far) {
    struct rows *it = calloc(1, sizeof *it);
    unsigned long state = 3;
    for (int t = 0; t < TRIP; t++) {
        it->s[t] = (int)(next_random(&state) % ROWS);
        it->value[t] = (double)next_random(&state) * 0x1p-60;
    }
    char *const all =
        mmap(NULL, distance + room, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    assert_ptr_not_equal(all, MAP_FAILED);
    assert_int_equal(mprotect(all, room, PROT_READ | PROT_WRITE), 0);
    assert_int_equal(mprotect(all + distance, room, PROT_READ | PROT_WRITE), 0);
    it->near = (double *)(void *)all;
    it->far = (double *)(void *)(all + distance);
    for (int r = 0; r < ROWS; r++)
        it->row[r] = (far && r % 3 == 0 ? it->far : it->near) + (r * 17 % ROWS) * WIDTH;
    return it;
}

static void free_rows(struct rows *it) {
    munmap(it->near, distance + room);
    free(it);
}

static void clear(struct rows *it) {
    memset(it->near, 0, used);
    memset(it->far, 0, used);
}

/* Runs the loop CALLS times and compares all bits with the expected result. Returns the number of
 * calls that ran in parallel. */
static int compare(struct rows *it, redcc_loop *loop, int threads) {
    double near[ROWS * WIDTH], far[ROWS * WIDTH];
    clear(it);
    oracle(it);
    memcpy(near, it->near, sizeof near);
    memcpy(far, it->far, sizeof far);
    int parallel = 0;
    for (int call = 0; call < CALLS; call++) {
        clear(it);
        parallel += run(it, loop, threads);
        assert_memory_equal(near, it->near, sizeof near);
        assert_memory_equal(far, it->far, sizeof far);
    }
    return parallel;
}

static const struct statistics *statistics_of(const redcc_loop *loop) {
    const struct loop_state *state = loop->state;
    return &state->reported.statistics;
}

static void each_element_has_its_order(bool is_far, int threads) {
    const struct settings *settings = redcc_settings();
    struct rows *it = new_rows(is_far);
    redcc_loop loop = new_loop();
    const int parallel = compare(it, &loop, threads);
    if (settings->method && (!is_far || !settings->method->in_levels)) {
        assert_int_equal(parallel, CALLS);
        assert_int_equal(statistics_of(&loop)->plans_built, 1);
    }
    double *const first = it->row[0];
    it->row[0] = it->row[1]; /* two equal pointers, and one to another row */
    compare(it, &loop, threads);
    if (settings->method && (!is_far || !settings->method->in_levels))
        assert_int_equal(statistics_of(&loop)->plans_built, 2);
    it->row[1] = first;
    it->row[5] = it->row[6] + WIDTH / 2;
    compare(it, &loop, threads);
    if (settings->validate) {
        assert_int_equal(statistics_of(&loop)->validated.executions, 0);
        assert_int_equal(statistics_of(&loop)->validated.passed_over, 3 * CALLS);
    }
    redcc_loop_forget(&loop);
    free_rows(it);
    assert_int_equal(redcc_memory_live(), 0);
}

static void rows_lie_in_one_block(void **unused) {
    (void)unused;
    for (int threads = 2; threads <= 7; threads += threads > 2 ? 4 : 1)
        each_element_has_its_order(false, threads);
}

/* The memory between rows must be neither read nor written, and owners must not be stored for each
 * unit of it. */
static void rows_lie_far_apart(void **unused) {
    (void)unused;
    for (int threads = 2; threads <= 7; threads += threads > 2 ? 4 : 1)
        each_element_has_its_order(true, threads);
}

static void what_is_read_lies_among_them(void **unused) {
    (void)unused;
    struct rows *it = new_rows(false);
    redcc_loop loop = new_loop();
    it->row[2] = it->value; /* row 2 lies in `value`, and the loop updates WIDTH elements of it */
    double kept[WIDTH], expected[WIDTH], near[ROWS * WIDTH];
    memcpy(kept, it->value, sizeof kept);
    oracle(it);
    memcpy(expected, it->value, sizeof expected);
    memcpy(near, it->near, sizeof near);
    clear(it);
    memcpy(it->value, kept, sizeof kept);
    assert_false(run(it, &loop, 3));
    assert_memory_equal(expected, it->value, sizeof expected);
    assert_memory_equal(near, it->near, sizeof near);
    redcc_loop_forget(&loop);
    free_rows(it);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(rows_lie_in_one_block),
                                       cmocka_unit_test(rows_lie_far_apart),
                                       cmocka_unit_test(what_is_read_lies_among_them)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
