/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Dry runs: the runtime never accepts a read of an element that was updated earlier, and no dry run
 * ends early if reads and updates are disjoint. The loop, which is recorded but not executed:
 *
 *     for (t = 0; t < TRIP; t++) {
 *         pool[at[0][t]] is read;  pool[at[1][t]] is updated
 *         pool[at[2][t]] is read;  pool[at[3][t]] is updated
 *     } */
#include "loop.h"

#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { TRIP = 400, POOL = 4000, PLACES = 4, TRIALS = 3000 };

static int at[PLACES][TRIP], pool[POOL];
static bool updated[POOL]; /* updated in the current dry run */
static long dry_runs, stale_reads;

static const redcc_array arrays[] = {{"b", REDCC_SUM, REDCC_INT32, 4, 4, 0},
                                     {"d", REDCC_SUM, REDCC_INT32, 4, 4, 0}};
static const redcc_source sources[] = {{"x", 1}, {"y", 1}};
static redcc_loop loop = {"test_dry_run.c",
                          1,
                          "run",
                          REDCC_ORDER_SERIAL,
                          REDCC_VERIFIABLE | REDCC_DRY_RUN | REDCC_DRY_RUN_OF_READS,
                          2,
                          arrays,
                          2,
                          sources,
                          0,
                          0};

static bool is_dry(const redcc_worker *worker) {
    return worker->alike < 0;
}

/* Returns false if the dry run is over. */
static bool read_one(redcc_worker *worker, redcc_u32 source, int place) {
    redcc_read(worker, source, &pool[place], sizeof *pool);
    if (redcc_is_over(worker, source))
        return false;
    if (is_dry(worker) && updated[place])
        stale_reads++;
    return true;
}

static bool update_one(redcc_worker *worker, redcc_u32 array, int place) {
    redcc_touch(worker, array, &pool[place], sizeof *pool);
    if (is_dry(worker))
        updated[place] = true;
    return worker->last > 0;
}

static void tell(redcc_worker *worker, redcc_int t) {
    if (is_dry(worker) && t == 0) {
        dry_runs++;
        memset(updated, 0, sizeof updated);
    }
    for (redcc_u32 i = 0; i < 2; i++)
        if (!read_one(worker, i, at[2 * i][t]) || !update_one(worker, i, at[2 * i + 1][t]))
            return;
}

static bool run(int threads) {
    void *const bases[] = {pool, pool};
    const redcc_extent known[] = {{(const char *)pool, 0}, {(const char *)pool, 0}};
    redcc_call call;
    assert_true(redcc_enter(&call, &loop, TRIP, bases, known, 0, threads, 0));
#pragma omp parallel num_threads(call.threads)
    {
        redcc_worker worker;
        redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
        while (redcc_inspect(&worker))
            for (redcc_int t = worker.first; t < worker.last; t += worker.stride) {
                tell(&worker, t);
                redcc_iteration_done(&worker);
            }
        while (redcc_next(&worker))
            continue;
    }
    const bool is_done = redcc_leave(&call);
    redcc_loop_forget(&loop);
    return is_done;
}

static unsigned long random_state = 7;

static int below(int limit) {
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (int)((random_state >> 33) % (unsigned long)limit);
}

/* Fills places in [first, first + length), in one of several orders. */
static void fill(int *place, int first, int length) {
    const int order = below(5);
    for (int t = 0; t < TRIP; t++) {
        const int up = (int)((long)t * length / TRIP);
        const int off = order == 0   ? up
                        : order == 1 ? length - 1 - up
                        : order == 2 ? below(length)
                        : order == 3 ? (length + (t % 2 ? up : -up)) / 2
                                     : length / 2;
        place[t] = first + (off < length ? off : length - 1);
    }
}

/* Fills adjacent ranges in any order, some with a small distance between them. */
static void fill_apart(void) {
    int order[PLACES] = {0, 1, 2, 3}, first = below(100);
    for (int i = PLACES - 1; i > 0; i--) {
        const int k = below(i + 1), other = order[i];
        order[i] = order[k];
        order[k] = other;
    }
    for (int i = 0; i < PLACES; i++) {
        const int length = 1 + below(below(2) ? 900 : 9);
        fill(at[order[i]], first, length);
        first += length + (below(2) ? 0 : below(60));
    }
}

static void nothing_ends_what_is_apart(void **unused) {
    (void)unused;
    dry_runs = stale_reads = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        fill_apart();
        if (!run(2 + trial % 2))
            fail_msg("trial %d: what is read lies apart, and the loop is not done", trial);
    }
    assert_int_equal(stale_reads, 0);
    assert_true(dry_runs > TRIALS); /* some runs are repeated, because margins were read */
    assert_true(dry_runs < 2 * TRIALS);
}

/* Makes one or more reads of updated elements, at random places. */
static void no_stale_read_passes(void **unused) {
    (void)unused;
    stale_reads = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        fill_apart();
        for (int strays = 1 + below(3); strays > 0; strays--)
            at[2 * below(2)][below(TRIP)] = at[2 * below(2) + 1][below(TRIP)];
        if (run(2 + trial % 2))
            fail_msg("trial %d: what is updated is read, and the loop is done", trial);
    }
    assert_int_equal(stale_reads, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(nothing_ends_what_is_apart),
                                       cmocka_unit_test(no_stale_read_passes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
