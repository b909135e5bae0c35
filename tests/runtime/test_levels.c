/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Iterations in levels: each pair of iterations is checked against the definition. Also tests that
 * auto uses levels if no cut of owners is good. */
#include "base/memory.h"
#include "loop.h"
#include "ownership/graph/levels.h"
#include "plan_check.h"
#include "problem.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST_TRIP = 600, MOST_TOUCHES = 4 };

/* Units that iterations touch. */
struct touches {
    int trip, count[MOST_TRIP], unit[MOST_TRIP][MOST_TOUCHES];
};

static bool meet(const struct touches *it, int s, int t) {
    for (int i = 0; i < it->count[s]; i++)
        for (int k = 0; k < it->count[t]; k++)
            if (it->unit[s][i] == it->unit[t][k])
                return true;
    return false;
}

/* Computes the levels by their definition. Returns their number. */
static int levels_by_definition(const struct touches *it, int *level) {
    int levels = 0;
    for (int t = 0; t < it->trip; t++) {
        level[t] = 0;
        for (int s = 0; s < t; s++)
            if (level[s] >= level[t] && meet(it, s, t))
                level[t] = level[s] + 1;
        levels = level[t] >= levels ? level[t] + 1 : levels;
    }
    return levels;
}

static struct touches random_touches(int trip, int units, int most, unsigned long seed) {
    struct touches it = {.trip = trip};
    for (int t = 0; t < trip; t++) {
        it.count[t] = (int)(next_random(&seed) % (unsigned long)(most + 1));
        for (int k = 0; k < it.count[t]; k++)
            it.unit[t][k] = (int)(next_random(&seed) % (unsigned long)units);
    }
    return it;
}

/* Logs the touches in the order in which `threads` threads would log them. */
static void tell(const struct touches *it, int threads, const struct units *units,
                 const struct partition *partition, struct access_log *logged, const char *b) {
    static struct range seen;
    for (int thread = 0; thread < threads; thread++) {
        const redcc_int begin = redcc_share(it->trip, threads, thread);
        assert_true(redcc_access_log_begin(&logged[thread], units, partition, &seen, begin,
                                           (const size_t[]){0, 0}, 1 << 20));
        for (redcc_int t = begin; t < redcc_share(it->trip, threads, thread + 1); t++) {
            redcc_entry entry[MOST_TOUCHES + 1] = {{0, 0, 0}};
            for (int k = 0; k < it->count[t]; k++)
                entry[k] = (redcc_entry){b + it->unit[t][k], 0, 1};
            entry[it->count[t]].array = REDCC_END_OF_ITERATION;
            redcc_access_log_take(&logged[thread], entry, entry + it->count[t] + 1);
        }
    }
}

/* Checks that each iteration that touches something, and the last one, is assigned once; with
 * `every` all iterations are. Of two iterations that touch a common unit, the first must be in an
 * earlier stage, or both must be in order in a stage of one thread. There must be at most as many
 * stages as levels. */
static void check(const struct touches *it, const struct levels *levels, bool every) {
    static int level[MOST_TRIP], stage[MOST_TRIP];
    const int known = levels_by_definition(it, level);
    assert_int_equal(levels->levels, known);
    assert_in_range(levels->stages, 1, known);
    for (int t = 0; t < it->trip; t++)
        stage[t] = -1;
    for (uint32_t s = 0; s < levels->stages; s++)
        for (uint32_t i = levels->stage[s].begin; i < levels->stage[s + 1].begin; i++) {
            assert_in_range(levels->iteration[i], 0, it->trip - 1);
            assert_int_equal(stage[levels->iteration[i]], -1);
            assert_true(i == levels->stage[s].begin ||
                        levels->iteration[i] > levels->iteration[i - 1]);
            stage[levels->iteration[i]] = (int)s;
        }
    for (int t = 0; t < it->trip; t++) {
        assert_int_equal(stage[t] >= 0, every || it->count[t] > 0 || t + 1 == it->trip);
        for (int s = 0; s < t; s++)
            if (meet(it, s, t))
                assert_true(stage[s] < stage[t] ||
                            (stage[s] == stage[t] && levels->stage[stage[s]].alone));
    }
}

static void check_shares(const struct levels *levels, int threads) {
    for (uint32_t stage = 0; stage < levels->stages; stage++) {
        uint32_t at = levels->stage[stage].begin;
        for (int thread = 0; thread < threads; thread++) {
            uint32_t first, end;
            redcc_levels_share(levels, stage, threads, thread, &first, &end);
            assert_true(first == end || first == at);
            assert_true(thread == 0 || first == end || !levels->stage[stage].alone);
            at += end - first;
        }
        assert_int_equal(at, levels->stage[stage + 1].begin);
    }
}

static void try_touches(const struct touches *it, int units_count, int threads, bool every) {
    static char b[4096];
    const redcc_array array = {"b", REDCC_SUM, REDCC_INT8, 1, 1, 0};
    const redcc_loop loop = {.arrays = &array, .array_count = 1};
    void *const base = b;
    const struct range touched = {(uintptr_t)b, (uintptr_t)(b + units_count)};
    struct partition partition;
    struct units units;
    struct access_log logged[8];
    struct levels levels;
    assert_true(redcc_partition_begin(&partition, &loop, &base, 2));
    assert_true(redcc_units_begin(&units, &partition, &touched));
    tell(it, threads, &units, &partition, logged, b);
    assert_true(redcc_levels_begin(&levels, logged, threads, every));
    check(it, &levels, every);
    check_shares(&levels, 3);
    assert_true(redcc_levels_length(&levels, 2) >= levels.count / 2.0);
    redcc_levels_end(&levels);
    for (int thread = 0; thread < threads; thread++)
        redcc_access_log_end(&logged[thread]);
    redcc_units_end(&units);
    redcc_partition_end(&partition);
    assert_int_equal(redcc_memory_live(), 0);
}

static void levels_are_those_of_the_definition(void **unused) {
    (void)unused;
    static const int units[] = {1, 3, 40, 300, 4000};
    for (int u = 0; u < 5; u++)
        for (int most = 1; most <= MOST_TOUCHES; most++)
            for (int threads = 1; threads <= 8; threads += 7) {
                const struct touches it =
                    random_touches(MOST_TRIP - u, units[u], most, 77 + (unsigned long)(u * most));
                try_touches(&it, units[u], threads, most % 2);
            }
}

static void a_chain_is_one_stage(void **unused) {
    (void)unused;
    struct touches it = {.trip = 500};
    for (int t = 0; t < it.trip; t++) {
        it.count[t] = 2;
        it.unit[t][0] = t;
        it.unit[t][1] = t + 1;
    }
    try_touches(&it, it.trip + 1, 2, false);
}

/* Returns a loop over random pairs of rows: with any cut half of the iterations have two owners. */
static struct problem random_pairs(long trip, int rows) {
    unsigned long random = 88172645463325252u;
    struct problem problem = {.name = "random pairs", .trip = trip, .rows = rows, .width = 1};
    problem.start = malloc((size_t)(trip + 1) * sizeof(int));
    problem.row = malloc(2 * (size_t)trip * sizeof(int));
    problem.other = calloc(2 * (size_t)trip, sizeof(int));
    problem.value = malloc(2 * (size_t)trip * sizeof(double));
    for (long t = 0; t <= trip; t++)
        problem.start[t] = (int)(2 * t);
    for (long k = 0; k < 2 * trip; k++) {
        problem.row[k] = (int)(next_random(&random) % (unsigned long)rows);
        problem.value[k] = (double)(k % 97) / 3.0;
    }
    problem.touches = 2 * trip;
    problem.doubles = rows;
    problem.first = malloc((size_t)rows * sizeof(double));
    return problem;
}

/* Calls the loop by auto and checks that each call gives the expected bits. Returns the number of
 * calls executed in levels. */
static int calls_by_levels(struct problem *problem, int threads, int calls) {
    struct described described;
    const size_t bytes = (size_t)problem->doubles * sizeof(double);
    double *expected = malloc(bytes);
    int found = 0;
    long last;
    problem_describe(problem, &described);
    problem_reset(problem);
    problem_oracle(problem);
    memcpy(expected, problem->first, bytes);
    for (int call = 0; call < calls; call++) {
        problem_reset(problem);
        problem_run(problem, &described, threads, &last);
        assert_memory_equal(problem->first, expected, bytes);
        const struct loop_state *state = described.loop.state;
        const bool by_levels = state->reported.statistics.method == &redcc_method_wavefront;
        found += by_levels;
        for (int p = 0; by_levels && p < REDCC_PLANS; p++)
            if (state->cache.kept[p] && state->cache.kept[p]->plan->method->in_levels)
                check_plan(problem, state->cache.kept[p]->plan);
    }
    redcc_loop_forget(&described.loop);
    free(expected);
    return found;
}

/* The credit is unlimited. */
static void auto_takes_levels_where_no_cut_serves(void **unused) {
    (void)unused;
    struct problem problem = random_pairs(100000, 60000);
    assert_true(calls_by_levels(&problem, 4, 12) >= 3);
    problem_free(&problem);
    problem = random_pairs(20000, 60); /* hundreds of levels */
    assert_int_equal(calls_by_levels(&problem, 4, 12), 0);
    problem_free(&problem);
    assert_int_equal(redcc_memory_live(), 0);
}

/* Before the levels exist, all allocations fail from one allocation on, which is a later one each
 * time. The results must be correct, and no memory may leak. */
static void memory_fails_on_the_way(void **unused) {
    (void)unused;
    /* FIRST: the call in which auto tries the graph; STEP: for speed, only every STEP-th allocation
     * fails */
    enum { FIRST = 1, STEP = 11 };
    struct problem problem = random_pairs(100000, 60000);
    const size_t bytes = (size_t)problem.doubles * sizeof(double);
    double *expected = malloc(bytes);
    problem_reset(&problem);
    problem_oracle(&problem);
    memcpy(expected, problem.first, bytes);
    bool exhausted = true;
    int by_levels = 0;
    for (long failing = 0; exhausted; failing += STEP) {
        struct described described;
        long last;
        problem_describe(&problem, &described);
        for (int call = 0; call < FIRST + 2; call++) {
            problem_reset(&problem);
            redcc_memory_fail_after(call == FIRST ? failing : -1);
            problem_run(&problem, &described, 4, &last);
            exhausted = call == FIRST ? redcc_memory_is_exhausted() : exhausted;
            redcc_memory_fail_after(-1);
            assert_memory_equal(problem.first, expected, bytes);
        }
        const struct loop_state *state = described.loop.state;
        by_levels += state->reported.statistics.method == &redcc_method_wavefront;
        redcc_loop_forget(&described.loop);
        assert_int_equal(redcc_memory_live(), 0);
        assert_int_equal(redcc_memory_in_use(), 0);
    }
    assert_true(by_levels > 0);
    free(expected);
    problem_free(&problem);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(levels_are_those_of_the_definition),
        cmocka_unit_test(a_chain_is_one_stage),
        cmocka_unit_test(auto_takes_levels_where_no_cut_serves),
        cmocka_unit_test(memory_fails_on_the_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
