/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Watched subscripts: every way of changing them is noticed, and where nothing changed they are not
 * read. Needs a system that can tell; else everything is as without, and the tests say so. */
#define _GNU_SOURCE /* mremap, process_vm_writev */
#include "loop.h"
#include "memory.h"
#include "problem.h"
#include "vouch.h"
#include "watch.h"
#include "written_pages.h"

#include <fcntl.h>
#include <malloc.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

enum {
    THREADS = 2,
    TRIP = 80000, /* subscripts of 320 KB */
    ROWS = 3000,
    HUGE_PAGE = 2 << 20,
    AT = TRIP / 2,           /* in a page in the middle */
    CALLS_UNTIL_WATCHED = 14 /* one builds the plan, patience is 12, one begins to watch */
};

static bool can_watch;

/* A loop over subscripts that lie where the test wants them to. */
struct fixture {
    struct problem problem;
    struct described described;
    double *expected;
    char *place; /* mapped; the subscripts begin some bytes into it */
    size_t place_bytes;
};

static char *map_pages(size_t bytes) {
    char *place = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_ptr_not_equal(place, MAP_FAILED);
    return place;
}

static void fill(int *row, unsigned long random) {
    for (long t = 0; t < TRIP; t++)
        row[t] = (int)(next_random(&random) % ROWS);
}

static void fixture_begin_at(struct fixture *fixture, int *row) {
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

static void fixture_begin(struct fixture *fixture) {
    fixture->place_bytes = 2 * HUGE_PAGE;
    fixture->place = map_pages(fixture->place_bytes);
    fixture_begin_at(fixture, (int *)(void *)(fixture->place + 400));
}

static void fixture_end_at(struct fixture *fixture) {
    redcc_loop_forget(&fixture->described.loop);
    free(fixture->problem.start);
    free(fixture->problem.value);
    free(fixture->problem.first);
    free(fixture->expected);
    assert_int_equal(redcc_memory_live(), 0);
}

static void fixture_end(struct fixture *fixture) {
    fixture_end_at(fixture);
    munmap(fixture->place, fixture->place_bytes);
}

static const struct statistics *statistics_of(const struct fixture *fixture) {
    return &((const struct loop_state *)fixture->described.loop.state)->reported.statistics;
}

/* Did the last run read all subscripts? */
static bool last_was_watched(struct fixture *fixture, long before) {
    return statistics_of(fixture)->watched > before;
}

/* Runs it, compares with the oracle, says whether subscripts were watched and not read. */
static bool run_right(struct fixture *fixture) {
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

/* Of `start` as well as of `row`; which of them a test changes, the other one stays watched. */
static uint32_t sources_watched(const struct fixture *fixture) {
    const struct loop_state *state = fixture->described.loop.state;
    return redcc_vouched_sources(&state->execution);
}

static void run_until_watched(struct fixture *fixture) {
    for (int call = 0; call < CALLS_UNTIL_WATCHED; call++)
        assert_false(run_right(fixture));
    assert_true(run_right(fixture));
    assert_int_equal(sources_watched(fixture), 2);
    assert_int_equal(statistics_of(fixture)->plans_built, 1);
}

static void need_watching(void) {
    if (!can_watch) {
        print_message("the system cannot tell which pages were written: nothing is tested\n");
        skip();
    }
}

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

static struct range rows_of(const struct fixture *fixture) {
    const int *row = fixture->problem.row;
    return redcc_whole_pages((struct range){(uintptr_t)row, (uintptr_t)(row + TRIP)});
}

/* ---- Ways of changing subscripts; each gives others from `AT` on. ---- */

static int other(const struct fixture *fixture) {
    return (fixture->problem.row[AT] + 1) % ROWS;
}

static void by_a_store(struct fixture *fixture) {
    fixture->problem.row[AT] = other(fixture);
}

static void by_a_store_at_the_begin(struct fixture *fixture) {
    fixture->problem.row[0] = other(fixture);
}

static void by_a_store_at_the_end(struct fixture *fixture) {
    fixture->problem.row[TRIP - 1] = other(fixture);
}

static void by_stores_all_over(struct fixture *fixture) {
    fill(fixture->problem.row, 4711);
}

static void by_memset(struct fixture *fixture) {
    memset(fixture->problem.row + AT, 0, 50000);
}

static void by_memcpy(struct fixture *fixture) {
    memcpy(fixture->problem.row + AT, fixture->problem.row, 60000);
}

static void by_read(struct fixture *fixture) {
    const int value = other(fixture);
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    assert_int_equal(write(ends[1], &value, sizeof value), sizeof value);
    assert_int_equal(read(ends[0], &fixture->problem.row[AT], sizeof value), sizeof value);
    close(ends[0]);
    close(ends[1]);
}

static void by_pread(struct fixture *fixture) {
    const int value = other(fixture);
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_int_equal(pwrite(fileno(file), &value, sizeof value, 0), sizeof value);
    assert_int_equal(pread(fileno(file), &fixture->problem.row[AT], sizeof value, 0), sizeof value);
    fclose(file);
}

static void by_receiving(struct fixture *fixture) {
    const int value = other(fixture);
    int ends[2];
    assert_int_equal(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
    assert_int_equal(send(ends[1], &value, sizeof value, 0), sizeof value);
    assert_int_equal(recv(ends[0], &fixture->problem.row[AT], sizeof value, 0), sizeof value);
    close(ends[0]);
    close(ends[1]);
}

static void *store_in_thread(void *fixture) {
    by_a_store(fixture);
    return NULL;
}

static void by_another_thread(struct fixture *fixture) {
    pthread_t thread;
    assert_int_equal(pthread_create(&thread, NULL, store_in_thread, fixture), 0);
    pthread_join(thread, NULL);
}

static void by_a_child_from_outside(struct fixture *fixture) {
    int value = other(fixture);
    const pid_t parent = getpid(), child = fork();
    if (child == 0) {
        const struct iovec from = {&value, sizeof value};
        const struct iovec to = {&fixture->problem.row[AT], sizeof value};
        _exit(process_vm_writev(parent, &from, 1, &to, 1, 0) != sizeof value);
    }
    int status;
    waitpid(child, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        print_message("process_vm_writev is not allowed: a store in its place\n");
        by_a_store(fixture);
    }
}

static void by_a_vfork_child(struct fixture *fixture) {
    volatile int *subscript = &fixture->problem.row[AT];
    const int before = *subscript;
    const pid_t child = vfork();
    if (child == 0) {
        *subscript = (before + 1) % ROWS;
        _exit(0);
    }
    waitpid(child, NULL, 0);
    if (*subscript == before) /* ThreadSanitizer makes a fork of it */
        by_a_store(fixture);
}

static char *page_in_the_middle(const struct fixture *fixture) {
    return (char *)((uintptr_t)&fixture->problem.row[AT] / 4096 * 4096);
}

static void by_dropping_a_page(struct fixture *fixture) {
    assert_int_equal(madvise(page_in_the_middle(fixture), 4096, MADV_DONTNEED), 0);
}

/* Whole page tables at once, perhaps. */
static void by_dropping_all(struct fixture *fixture) {
    assert_int_equal(madvise(fixture->place, fixture->place_bytes, MADV_DONTNEED), 0);
}

static void by_mapping_over_the_middle(struct fixture *fixture) {
    assert_ptr_not_equal(mmap(page_in_the_middle(fixture), 8192, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0),
                         MAP_FAILED);
}

static void by_mapping_all_anew(struct fixture *fixture) {
    munmap(fixture->place, fixture->place_bytes);
    assert_ptr_equal(mmap(fixture->place, fixture->place_bytes, PROT_READ | PROT_WRITE,
                          MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0),
                     fixture->place);
    fill(fixture->problem.row, 4711);
}

static void by_mapping_a_file(struct fixture *fixture) {
    FILE *file = tmpfile();
    assert_non_null(file);
    static const char zeros[8192];
    assert_int_equal(fwrite(zeros, 1, sizeof zeros, file), sizeof zeros);
    fflush(file);
    assert_ptr_not_equal(mmap(page_in_the_middle(fixture), sizeof zeros, PROT_READ,
                              MAP_PRIVATE | MAP_FIXED, fileno(file), 0),
                         MAP_FAILED);
    fclose(file);
}

/* Pages that are watched too, unwritten, and now lie where the subscripts lay. */
static void by_moving_watched_pages_here(struct fixture *fixture) {
    const size_t bytes = fixture->place_bytes;
    char *elsewhere = map_pages(bytes);
    memcpy(elsewhere, fixture->place, bytes);
    fill((int *)(void *)(elsewhere + 400), 4711);
    const uint64_t version =
        redcc_watch_begin((struct range){(uintptr_t)elsewhere, (uintptr_t)elsewhere + bytes});
    assert_true(version > 0);
    assert_ptr_equal(mremap(elsewhere, bytes, bytes, MREMAP_MAYMOVE | MREMAP_FIXED, fixture->place),
                     fixture->place);
}

/* The same, and afterwards other pages of the same mapping are watched, which makes the mapping
 * known to the system again. */
static void by_moving_and_watching_beside(struct fixture *fixture) {
    by_moving_watched_pages_here(fixture);
    const uintptr_t end = (uintptr_t)fixture->place + fixture->place_bytes;
    assert_true(redcc_watch_begin((struct range){end - (1 << 20), end}) > 0);
}

static void by_writing_while_unprotected_once_more(struct fixture *fixture) {
    assert_int_equal(mprotect(fixture->place, fixture->place_bytes, PROT_READ), 0);
    assert_int_equal(mprotect(fixture->place, fixture->place_bytes, PROT_READ | PROT_WRITE), 0);
    by_a_store(fixture);
}

/* Another loop watches the written page anew, or a range that overlaps: the marks are gone. */
static void and_another_watches_the_range(struct fixture *fixture) {
    by_a_store(fixture);
    assert_true(redcc_watch_begin(rows_of(fixture)) > 0);
}

static void and_another_watches_a_part(struct fixture *fixture) {
    by_a_store(fixture);
    const uintptr_t first = (uintptr_t)page_in_the_middle(fixture) - 8192;
    assert_true(redcc_watch_begin((struct range){first, first + 65536}) > 0);
}

static void by_forking_and_storing(struct fixture *fixture) {
    const pid_t child = fork();
    if (child == 0)
        _exit(0);
    by_a_store(fixture); /* while the pages are shared with the child, or after */
    waitpid(child, NULL, 0);
}

static const struct way {
    const char *name;
    void (*change)(struct fixture *);
} ways[] = {
    {"a store", by_a_store},
    {"a store at the begin", by_a_store_at_the_begin},
    {"a store at the end", by_a_store_at_the_end},
    {"stores all over", by_stores_all_over},
    {"memset", by_memset},
    {"memcpy", by_memcpy},
    {"read", by_read},
    {"pread", by_pread},
    {"recv", by_receiving},
    {"another thread", by_another_thread},
    {"a child from outside", by_a_child_from_outside},
    {"a vfork child", by_a_vfork_child},
    {"dropping a page", by_dropping_a_page},
    {"dropping all", by_dropping_all},
    {"mapping over the middle", by_mapping_over_the_middle},
    {"mapping all anew", by_mapping_all_anew},
    {"mapping a file", by_mapping_a_file},
    {"moving watched pages here", by_moving_watched_pages_here},
    {"moving, and watching beside", by_moving_and_watching_beside},
    {"mprotect", by_writing_while_unprotected_once_more},
    {"another watches the range", and_another_watches_the_range},
    {"another watches a part", and_another_watches_a_part},
    {"fork", by_forking_and_storing},
};

static void changes_are_noticed(void **unused) {
    (void)unused;
    need_watching();
    for (size_t way = 0; way < sizeof ways / sizeof *ways; way++) {
        struct fixture fixture;
        fixture_begin(&fixture);
        run_until_watched(&fixture);
        ways[way].change(&fixture);
        run_right(&fixture);
        if (statistics_of(&fixture)->plans_built != 2)
            fail_msg("changed by %s: the plan is used again", ways[way].name);
        assert_false(run_right(&fixture) && sources_watched(&fixture) == 2);
        assert_int_equal(statistics_of(&fixture)->plans_built, 2);
        fixture_end(&fixture);
    }
}

/* ---- What must not be disturbed. ---- */

/* Rewritten with what they held: no other plan is made, and after that they are watched again. */
static void the_same_values_again(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin(&fixture);
    run_until_watched(&fixture);
    fixture.problem.row[AT] += 0;
    *(volatile int *)&fixture.problem.row[AT] = fixture.problem.row[AT];
    assert_true(run_right(&fixture)); /* start was not read */
    assert_int_equal(sources_watched(&fixture), 1);
    assert_int_equal(statistics_of(&fixture)->plans_built, 1);
    int calls = 0; /* in vain once: twice the patience */
    while (sources_watched(&fixture) < 2 && calls++ < 100)
        run_right(&fixture);
    assert_in_range(calls, 20, 30);
    fixture_end(&fixture);
}

/* Who rewrites his subscripts before each execution has them watched less and less often. */
static void patience_grows(void **unused) {
    (void)unused;
    need_watching();
    struct fixture fixture;
    fixture_begin(&fixture);
    run_until_watched(&fixture);
    for (int round = 0; round < 4; round++) {
        fill(fixture.problem.row, 88172645463325252u);
        run_right(&fixture);
        for (int call = 0; call < 12 << (round + 1) && sources_watched(&fixture) < 2; call++)
            run_right(&fixture);
    }
    const struct loop_state *state = fixture.described.loop.state;
    assert_in_range(state->setbacks, 3, 5);
    assert_int_equal(statistics_of(&fixture)->plans_built, 1);
    fixture_end(&fixture);
}

/* A second loop over the same subscripts need not wait. */
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
    run_until_watched(&fixture);
    int *const old = fixture.problem.row;
    free(old);
    fixture.problem.row = malloc(TRIP * sizeof(int));
    fill(fixture.problem.row, 4711);
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 2);
    for (int size = 2; size < 64; size *= 2) { /* grows, perhaps moves */
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

/* Not private, or not of the processor alone: read each time. */
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

/* The program gets the descriptors that it would get anyway. */
static void descriptors_stay_low(void **unused) {
    (void)unused;
    need_watching();
    const int before = dup(0);
    close(before);
    struct fixture fixture;
    fixture_begin(&fixture);
    run_until_watched(&fixture);
    const int after = dup(0);
    close(after);
    assert_int_equal(before, after);
    fixture_end(&fixture);
}

/* In a process of its own; returns whether it ended well. */
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

/* Not the loop, which would want threads: the registry alone. */
static void in_a_child(struct fixture *fixture) {
    const struct range pages = rows_of(fixture);
    CHECK(!redcc_pages_begun());
    CHECK(redcc_watch_share(pages) == 0); /* what the parent knows is of the parent's memory */
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
    run_until_watched(&fixture);
    assert_true(in_child(in_a_child, &fixture)); /* its store is not the parent's */
    assert_true(run_right(&fixture));
    assert_int_equal(sources_watched(&fixture), 2);
    by_a_store(&fixture);
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 2);
    fixture_end(&fixture);
}

/* The program closes whatever is open, and opens something else under those numbers. */
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

/* It was time to watch the subscripts of a plan, but then fewer threads came and another plan was
 * compared: nothing is known of the first one's. */
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

/* Huge pages are protected in one piece, and dropped in one piece. */
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

/* Descriptors by which others may write to memory, or take marks away. */
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

/* More ranges than there are places for. */
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

/* In the memory that brk gives and takes back. Last: malloc gets enough of it for all that it will
 * be asked for, so that the end of it is the test's. */
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
    run_until_watched(&fixture);
    assert_ptr_equal(sbrk(bytes), begin + bytes); /* grows beyond what is watched */
    memset(begin + bytes, 1, (size_t)bytes);
    assert_true(run_right(&fixture));
    assert_ptr_not_equal(sbrk(-bytes - bytes), (void *)-1); /* given back, taken again: zeros */
    assert_ptr_equal(sbrk(bytes), begin);
    run_right(&fixture);
    assert_int_equal(statistics_of(&fixture)->plans_built, 2);
    fixture_end_at(&fixture);
}

/* Everything is as it was before there was watching. */
static void switched_off(void **unused) {
    (void)unused;
    struct fixture fixture;
    fixture_begin(&fixture);
    for (int call = 0; call < CALLS_UNTIL_WATCHED + 5; call++)
        assert_false(run_right(&fixture));
    assert_false(redcc_pages_begun());
    fixture_end(&fixture);
}

static bool try_to_watch(void) {
    char *place = map_pages(8192);
    *place = 1;
    const bool watched =
        redcc_watch_begin((struct range){(uintptr_t)place, (uintptr_t)place + 8192}) > 0;
    munmap(place, 8192);
    return watched;
}

int main(void) {
    const struct CMUnitTest off[] = {cmocka_unit_test(switched_off)};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_changed),
        cmocka_unit_test(changes_are_noticed),
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
        cmocka_unit_test(many_ranges),
        cmocka_unit_test(subscripts_in_the_heap),
    };
    const char *watch = getenv("REDCC_WATCH");
    if (watch && strcmp(watch, "off") == 0)
        return cmocka_run_group_tests(off, NULL, NULL);
    can_watch = try_to_watch();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
