/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Write tracking of subscripts: unmodified subscripts are not read, and tracking does not disturb
 * the program. On a system without page tracking the tests are skipped with a message. */
#define _GNU_SOURCE /* sbrk, syscall */
#include "watched.h"

#include "reuse/pages/watch.h"
#include "reuse/pages/written_pages.h"
#include "reuse/tracking.h"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <malloc.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

static void nothing_changed(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin(&fixture);
    run_until_watched(&fixture);
    for (int call = 0; call < 20; call++)
        assert_true(run_right(&fixture));
    for (long t = 0; t < TRIP; t++) /* no subscript */
        fixture.problem.value[t] += 1;
    assert_true(run_right(&fixture));
    assert_int_equal(statistics_of(&fixture)->plans_built, 1);
    fixture_end(&fixture);
}

/* Subscripts are rewritten with the same values: no other plan is built, and later the subscripts
 * are tracked again. */
static void the_same_values_again(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin(&fixture);
    run_until_watched(&fixture);
    fixture.problem.row[AT] += 0;
    *(volatile int *)&fixture.problem.row[AT] = fixture.problem.row[AT];
    assert_true(run_right(&fixture)); /* `start` was not read */
    assert_int_equal(sources_watched(&fixture), 1);
    assert_int_equal(statistics_of(&fixture)->plans_built, 1);
    int calls = 0; /* after one failure the threshold is doubled */
    while (sources_watched(&fixture) < 2 && calls++ < 200)
        run_right(&fixture);
    assert_in_range(calls, 70, 90);
    fixture_end(&fixture);
}

/* Subscripts that are rewritten before each execution are tracked less and less often
 * (back-off). */
static void patience_grows(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin(&fixture);
    run_until_watched(&fixture);
    for (int round = 0; round < 2; round++) {
        fill(fixture.problem.row, 88172645463325252u);
        run_right(&fixture);
        for (int call = 0; call < 40 << (round + 1) && sources_watched(&fixture) < 2; call++)
            run_right(&fixture);
    }
    const struct loop_state *state = fixture.described.loop.state;
    assert_in_range(state->cache.back_off.length, 2 * LEARN_BACK_OFF, 4 * LEARN_BACK_OFF);
    assert_int_equal(statistics_of(&fixture)->plans_built, 1);
    fixture_end(&fixture);
}

/* A second loop with the same subscripts uses their tracking at once. */
static void loops_share_what_is_watched(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    struct described second;
    fixture_begin(&fixture);
    run_until_watched(&fixture);
    problem_describe(&fixture.problem, &second);
    long last;
    for (int call = 0; call < 3; call++)
        assert_true(problem_run(&fixture.problem, &second, 2, &last));
    const struct loop_state *state = second.loop.state;
    assert_int_equal(state->reported.statistics.watched, 1);
    by_a_store(&fixture);
    assert_true(problem_run(&fixture.problem, &second, 2, &last));
    assert_int_equal(state->reported.statistics.plans_built, 2);
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 2);
    redcc_loop_forget(&second.loop);
    fixture_end(&fixture);
}

static void freed_and_taken_again(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin_at(&fixture, malloc(TRIP * sizeof(int)));
    run_and_share(&fixture);
    int *const old = fixture.problem.row;
    free(old);
    fixture.problem.row = malloc(TRIP * sizeof(int));
    fill(fixture.problem.row, 4711);
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 2);
    for (int size = 2; size < 64; size *= 2) { /* the memory grows and may move */
        fixture.problem.row = realloc(fixture.problem.row, (size_t)size * TRIP * sizeof(int));
        assert_non_null(fixture.problem.row);
        fill(fixture.problem.row, (unsigned long)size);
        const long built = statistics_of(&fixture)->plans_built;
        run_right(&fixture);
        assert_int_equal(statistics_of(&fixture)->plans_built, built + 1);
    }
    free(fixture.problem.row);
    fixture_end_at(&fixture);
}

/* Memory that is not private, or that devices may write, is read in each call. */
static void what_others_may_write_is_not_watched(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture.place_bytes = 1 << 20;
    fixture.place =
        mmap(NULL, fixture.place_bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    assert_ptr_not_equal(fixture.place, MAP_FAILED);
    fixture_begin_at(&fixture, (int *)(void *)fixture.place);
    for (int call = 0; call < CALLS_UNTIL_WATCHED + 3; call++) {
        run_right(&fixture);
        assert_true(sources_watched(&fixture) < 2);
    }
    const struct loop_state *state = fixture.described.loop.state;
    assert_int_equal(state->cache.back_off.length,
                     LEARN_BACK_OFF); /* not tried again in each call */
    const pid_t child = fork();
    if (child == 0) {
        by_a_store(&fixture);
        _exit(0);
    }
    waitpid(child, NULL, 0);
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 2);
    fixture_end(&fixture);
}

static int room_at_start;

static int room_for_descriptors(void) {
    char line[256];
    int room = 0;
    FILE *status = fopen("/proc/self/status", "r");
    assert_non_null(status);
    while (fgets(line, sizeof line, status))
        if (strncmp(line, "FDSize:", 7) == 0)
            room = atoi(line + 7);
    fclose(status);
    return room;
}

/* The program gets the same descriptors as without tracking. The descriptor table does not grow,
 * since that would take long in a process with threads. */
static void descriptors_stay_low(void **unused) {
    (void)unused;
    need_watching();
    const int before = dup(0);
    close(before);
    struct fixture fixture;
    fixture_begin(&fixture);
    run_and_share(&fixture);
    const int after = dup(0);
    close(after);
    assert_int_equal(before, after);
    assert_int_equal(room_for_descriptors(), room_at_start);
    fixture_end(&fixture);
}

/* Runs the test in a child process. Returns whether it succeeded. */
static bool in_child(void (*test)(struct fixture *), struct fixture *fixture) {
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        test(fixture);
        _exit(0);
    }
    int status;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

#define CHECK(condition)                                                                           \
    do                                                                                             \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                        \
            _exit(1);                                                                              \
        }                                                                                          \
    while (0)

/* Tests only the registry of tracked pages, since a loop would need threads. */
static void in_a_child(struct fixture *fixture) {
    const struct range pages = rows_of(fixture);
    CHECK(!redcc_pages_begun());
    CHECK(redcc_watch_share(pages) == 0); /* the parent's versions refer to the parent's memory */
    for (uint64_t version = 1; version < 200; version++)
        CHECK(redcc_watch_ask(pages, version) == WATCH_TOUCHED);
    const uint64_t version = redcc_watch_begin(pages);
    CHECK(version > 0);
    CHECK(redcc_watch_ask(pages, version) == WATCH_UNTOUCHED);
    by_a_store(fixture);
    CHECK(redcc_watch_ask(pages, version) == WATCH_TOUCHED);
}

static void forked(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin(&fixture);
    run_and_share(&fixture);
    /* a store of the child does not change the parent's memory */
    assert_true(in_child(in_a_child, &fixture));
    assert_true(run_right(&fixture));
    assert_int_equal(sources_watched(&fixture), 2);
    by_a_store(&fixture);
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 2);
    fixture_end(&fixture);
}

/* The program closes all descriptors and opens other files under their numbers. */
static void without_descriptors(struct fixture *fixture) {
    const struct range pages = rows_of(fixture);
    uint64_t version = redcc_watch_begin(pages);
    CHECK(version > 0);
    CHECK(redcc_watch_ask(pages, version) == WATCH_UNTOUCHED);
    for (int number = 3; number < 2048; number++)
        if (close(number) == 0)
            CHECK(dup2(0, number) == number);
    CHECK(redcc_watch_ask(pages, version) == WATCH_TOUCHED);
    CHECK(redcc_watch_begin(pages) == 0);
    CHECK(redcc_watch_begin(pages) == 0);
}

static void descriptors_are_closed(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin(&fixture);
    assert_true(in_child(without_descriptors, &fixture));
    fixture_end_at(&fixture);
    munmap(fixture.place, fixture.place_bytes);
}

/* Tracking of a plan's subscripts has begun, but then fewer threads arrived and another plan was
 * compared. The first plan's subscripts stay unknown. */
static void watched_but_not_compared(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin(&fixture);
    long last;
    for (int call = 0; call < CALLS_UNTIL_WATCHED - 1; call++)
        assert_false(run_right(&fixture));
    by_stores_all_over(&fixture);
    assert_int_equal(
        problem_run_fewer(&fixture.problem, &fixture.described, THREADS, THREADS - 1, &last), 0);
    assert_int_equal(redcc_watch_share(rows_of(&fixture)) > 0, 1);
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 2);
    fixture_end(&fixture);
}

/* Huge pages are protected and dropped as a whole. */
static void a_huge_page(void **unused) {
    (void)unused;
    need_watching();
    const size_t huge = HUGE_PAGE, bytes = 4 * huge;
    char *place = map_pages(bytes);
    char *const aligned = (char *)(((uintptr_t)place + huge - 1) / huge * huge);
    const struct range pages = {(uintptr_t)aligned, (uintptr_t)aligned + 2 * huge};
    madvise(place, bytes, MADV_HUGEPAGE);
    for (int way = 0; way < 3; way++) {
        memset(place, 1, bytes);
        const uint64_t version = redcc_watch_begin(pages);
        assert_true(version > 0);
        assert_int_equal(redcc_watch_ask(pages, version), WATCH_UNTOUCHED);
        if (way == 0)
            ((volatile char *)aligned)[huge + 12345] = 2;
        else
            assert_int_equal(madvise(aligned, way == 1 ? huge : 2 * huge, MADV_DONTNEED), 0);
        assert_int_equal(redcc_watch_ask(pages, version), WATCH_TOUCHED);
    }
    munmap(place, bytes);
}

/* Open descriptors through which memory may be written, or marks removed, prevent tracking. */
static void what_is_open_forbids_it(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin(&fixture);
    char parameters[256] = {0};
    const int opened[] = {(int)syscall(SYS_userfaultfd, O_CLOEXEC | 1),
                          (int)syscall(SYS_io_uring_setup, 4, parameters)};
    for (int i = 0; i < 2; i++)
        if (opened[i] >= 0) {
            assert_int_equal(redcc_watch_begin(rows_of(&fixture)), 0);
            close(opened[i]);
        }
    assert_true(redcc_watch_begin(rows_of(&fixture)) > 0);
    fixture_end(&fixture);
}

/* Under a seccomp filter a system call may kill the process, so none may be made. */
static void under_a_filter(struct fixture *fixture) {
    struct sock_filter allow = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    const struct sock_fprog filter = {1, &allow};
    CHECK(redcc_watch_begin(rows_of(fixture)) > 0);
    CHECK(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0);
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0)
        return;
    by_a_store(fixture);
    CHECK(redcc_watch_begin(rows_of(fixture)) == 0);
}

static void nothing_is_asked_under_a_filter(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin(&fixture);
    assert_true(in_child(under_a_filter, &fixture));
    fixture_end(&fixture);
}

/* More ranges than the registry has slots. */
static void many_ranges(void **unused) {
    (void)unused;
    need_watching();
    enum { RANGES = 100 };
    uint64_t version[RANGES];
    char *place = map_pages(RANGES * 8192);
    memset(place, 1, RANGES * 8192);
    struct range pages[RANGES];
    for (int i = 0; i < RANGES; i++) {
        pages[i].first = (uintptr_t)place + (uintptr_t)i * 8192;
        pages[i].end = pages[i].first + 8192;
        version[i] = redcc_watch_begin(pages[i]);
        assert_true(version[i] > 0);
    }
    int known = 0;
    for (int i = 0; i < RANGES; i++)
        known += redcc_watch_ask(pages[i], version[i]) == WATCH_UNTOUCHED;
    assert_in_range(known, 32, RANGES - 1);
    memset(place, 1, RANGES * 8192);
    for (int i = 0; i < RANGES; i++)
        assert_int_equal(redcc_watch_ask(pages[i], version[i]), WATCH_TOUCHED);
    munmap(place, RANGES * 8192);
}

/* Subscripts in the heap, which brk extends and shrinks. This test is the last one: afterwards
 * malloc needs no memory from the system, and nothing else moves the heap's end. */
static void subscripts_in_the_heap(void **unused) {
    (void)unused;
    need_watching();
    const intptr_t bytes = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    void *volatile room = malloc(24 << 20);
    free(room);
    char *const begin = sbrk(bytes);
    if (begin == (void *)-1 || sbrk(0) != begin + bytes) {
        print_message("no heap to be had\n");
        skip();
    }
    struct fixture fixture;
    fixture_begin_at(&fixture, (int *)(void *)begin);
    run_and_share(&fixture);
    assert_ptr_equal(sbrk(bytes), begin + bytes); /* the heap grows beyond the tracked range */
    memset(begin + bytes, 1, (size_t)bytes);
    assert_true(run_right(&fixture));
    /* returned to the system and allocated again, the memory contains zeros */
    assert_ptr_not_equal(sbrk(-bytes - bytes), (void *)-1);
    assert_ptr_equal(sbrk(bytes), begin);
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 2);
    fixture_end_at(&fixture);
}

/* Makes it seem that auto ran the original loop in this many calls. */
static void let_rest(struct fixture *fixture, long calls) {
    struct loop_state *state = fixture->described.loop.state;
    state->chooser.skipped += calls;
}

/* Makes it seem that the plan has saved this many seconds beyond its construction before the next
 * call. */
static void let_earn(struct fixture *fixture, double seconds) {
    struct loop_state *state = fixture->described.loop.state;
    for (int size = 0; size < REDCC_SIZES; size++) {
        struct set_ups *set_ups = &state->chooser.state.size[size].set_ups;
        set_ups->invested = 0.25;
        set_ups->earned = 0.25 + seconds;
    }
}

/* Subscripts that did not change during a back-off of auto are tracked at the first retry, whose
 * time benefits from tracking. */
static void calls_at_rest_count(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    long last;
    fixture_begin(&fixture);
    assert_false(problem_run(&fixture.problem, &fixture.described, THREADS, &last));
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 1);
    let_rest(&fixture, 5);
    for (int call = 0; call < 3; call++) {
        let_earn(&fixture, 0); /* otherwise savings would pay for tracking (see savings_pay) */
        assert_false(run_right(&fixture));
    }
    let_rest(&fixture, 100);
    let_earn(&fixture, 0);
    assert_false(run_right(&fixture)); /* compared */
    let_earn(&fixture, 0);
    assert_false(run_right(&fixture)); /* protects and compares the pages */
    assert_true(run_right(&fixture));
    assert_int_equal(sources_watched(&fixture), 2);
    by_a_store(&fixture); /* the change is detected: the original loop runs, then a new plan */
    assert_false(problem_run(&fixture.problem, &fixture.described, THREADS, &last));
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 2);
    fixture_end(&fixture);
}

/* The plan's savings pay for tracking one source after the other, long before comparisons have cost
 * as much. Tracking a source of 78 pages costs 1.4 microseconds per page plus 250 microseconds. */
static void savings_pay(void **unused) {
    (void)unused;
    need_watching();
    const double price = 78 * 1.4e-6 + 250e-6;
    struct fixture fixture;
    long last;
    fixture_begin(&fixture);
    assert_false(problem_run(&fixture.problem, &fixture.described, THREADS, &last));
    run_right(&fixture);
    for (int call = 0; call < 3; call++) {
        let_earn(&fixture, 0.9 * price);
        assert_false(run_right(&fixture));
    }
    let_earn(&fixture, 1.8 * price); /* enough for one of the two sources */
    assert_false(run_right(&fixture));
    let_earn(&fixture, 0);
    assert_true(run_right(&fixture));
    assert_int_equal(sources_watched(&fixture), 1);
    let_earn(&fixture, 1.1 * price);
    run_right(&fixture);
    let_earn(&fixture, 0);
    assert_true(run_right(&fixture));
    assert_int_equal(sources_watched(&fixture), 2);
    assert_int_equal(statistics_of(&fixture)->plans_built, 1);
    fixture_end(&fixture);
}

/* Without tracking, subscripts are always read. */
static void switched_off(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture);
    for (int call = 0; call < CALLS_UNTIL_WATCHED + 5; call++)
        assert_false(run_right(&fixture));
    assert_false(redcc_pages_begun());
    fixture_end(&fixture);
}

int main(void) {
    room_at_start = room_for_descriptors();
    const struct CMUnitTest off[] = {cmocka_unit_test(switched_off)};
    const struct CMUnitTest chosen[] = {cmocka_unit_test(calls_at_rest_count),
                                        cmocka_unit_test(savings_pay)};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_changed),
        cmocka_unit_test(the_same_values_again),
        cmocka_unit_test(patience_grows),
        cmocka_unit_test(loops_share_what_is_watched),
        cmocka_unit_test(freed_and_taken_again),
        cmocka_unit_test(what_others_may_write_is_not_watched),
        cmocka_unit_test(descriptors_stay_low),
        cmocka_unit_test(forked),
        cmocka_unit_test(descriptors_are_closed),
        cmocka_unit_test(watched_but_not_compared),
        cmocka_unit_test(a_huge_page),
        cmocka_unit_test(what_is_open_forbids_it),
        cmocka_unit_test(nothing_is_asked_under_a_filter),
        cmocka_unit_test(many_ranges),
        cmocka_unit_test(subscripts_in_the_heap),
    };
    const char *watch = getenv("REDCC_WATCH");
    if (watch && strcmp(watch, "off") == 0)
        return cmocka_run_group_tests(off, NULL, NULL);
    if (!getenv("REDCC_METHOD"))
        return cmocka_run_group_tests(chosen, NULL, NULL);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
