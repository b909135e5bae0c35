/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* MAP_ANONYMOUS */
#include "watched.h"

#include "base/memory.h"
#include "reuse/pages/watch.h"
#include "reuse/pages/written_pages.h"
#include "reuse/tracking.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <cmocka.h>

char *map_pages(size_t bytes) {
    char *place = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_ptr_not_equal(place, MAP_FAILED);
    return place;
}

void fill(int *row, unsigned long random) {
    for (long t = 0; t < TRIP; t++)
        row[t] = (int)(next_random(&random) % ROWS);
}

void fixture_begin_at(struct fixture *fixture, int *row) {
    struct problem *problem = &fixture->problem;
    *problem = (struct problem){.trip = TRIP, .touches = TRIP, .rows = ROWS, .width = 1};
    problem->start = malloc((TRIP + 1) * sizeof *problem->start);
    problem->value = malloc(TRIP * sizeof *problem->value);
    problem->first = malloc(ROWS * sizeof(double));
    problem->doubles = ROWS;
    problem->row = row;
    for (long t = 0; t <= TRIP; t++)
        problem->start[t] = (int)t;
    for (long t = 0; t < TRIP; t++)
        problem->value[t] = (double)(t % 9 + 1) / 3.0;
    fill(row, 88172645463325252u);
    problem_describe(problem, &fixture->described);
    fixture->expected = malloc(ROWS * sizeof(double));
}

void fixture_begin(struct fixture *fixture) {
    fixture->place_bytes = 2 * HUGE_PAGE;
    fixture->place = map_pages(fixture->place_bytes);
    fixture_begin_at(fixture, (int *)(void *)(fixture->place + 400));
}

void fixture_end_at(struct fixture *fixture) {
    redcc_loop_forget(&fixture->described.loop);
    free(fixture->problem.start);
    free(fixture->problem.value);
    free(fixture->problem.first);
    free(fixture->expected);
    assert_int_equal(redcc_memory_live(), 0);
}

void fixture_end(struct fixture *fixture) {
    fixture_end_at(fixture);
    munmap(fixture->place, fixture->place_bytes);
}

const struct statistics *statistics_of(const struct fixture *fixture) {
    return &((const struct loop_state *)fixture->described.loop.state)->reported.statistics;
}

/* Did the last run leave some subscripts unread, because tracking showed them unmodified? */
static bool last_was_watched(struct fixture *fixture, long before) {
    return statistics_of(fixture)->watched > before;
}

/* Runs the loop and compares with the expected result. Returns true if tracking made reading some
 * subscripts unnecessary. */
bool run_right(struct fixture *fixture) {
    struct problem *problem = &fixture->problem;
    const size_t bytes = (size_t)problem->doubles * sizeof(double);
    const long before = fixture->described.loop.state ? statistics_of(fixture)->watched : 0;
    long last;
    problem_reset(problem);
    problem_oracle(problem);
    memcpy(fixture->expected, problem->first, bytes);
    problem_reset(problem);
    assert_true(problem_run(problem, &fixture->described, THREADS, &last));
    assert_memory_equal(fixture->expected, problem->first, bytes);
    return last_was_watched(fixture, before);
}

/* Counts both `start` and `row`: a test changes one of them, and the other stays tracked. */
uint32_t sources_watched(const struct fixture *fixture) {
    const struct loop_state *state = fixture->described.loop.state;
    return redcc_reuse_skipped_sources(&state->execution.reuse);
}

void run_until_watched(struct fixture *fixture) {
    for (int call = 0; call < CALLS_UNTIL_WATCHED; call++)
        assert_false(run_right(fixture));
    assert_true(run_right(fixture));
    assert_int_equal(sources_watched(fixture), 2);
    assert_int_equal(statistics_of(fixture)->plans_built, 1);
}

struct range rows_of(const struct fixture *fixture) {
    const int *row = fixture->problem.row;
    return redcc_whole_pages((struct range){(uintptr_t)row, (uintptr_t)(row + TRIP)});
}

void run_and_share(struct fixture *fixture) {
    const int *start = fixture->problem.start;
    const struct range starts = {(uintptr_t)start, (uintptr_t)(start + TRIP + 1)};
    assert_true(redcc_watch_begin(rows_of(fixture)) > 0);
    assert_true(redcc_watch_begin(redcc_whole_pages(starts)) > 0);
    assert_false(run_right(fixture));
    assert_false(run_right(fixture));
    assert_true(run_right(fixture));
    assert_int_equal(sources_watched(fixture), 2);
    assert_int_equal(statistics_of(fixture)->plans_built, 1);
}

int other(const struct fixture *fixture) {
    return (fixture->problem.row[AT] + 1) % ROWS;
}

void by_a_store(struct fixture *fixture) {
    fixture->problem.row[AT] = other(fixture);
}

void by_stores_all_over(struct fixture *fixture) {
    fill(fixture->problem.row, 4711);
}

static bool try_to_watch(void) {
    char *place = map_pages(8192);
    *place = 1;
    const bool watched =
        redcc_watch_begin((struct range){(uintptr_t)place, (uintptr_t)place + 8192}) > 0;
    munmap(place, 8192);
    return watched;
}

void need_watching(void) {
    if (!redcc_pages_begun() && !try_to_watch()) {
        print_message("the system cannot tell which pages were written: nothing is tested\n");
        skip();
    }
}
