/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The runtime's own threads, in a program without an OpenMP library. */
#include "base/pool.h"
#include "base/region.h"
#include "base/signals.h"

#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <unistd.h>

#include <cmocka.h>

#include <dirent.h>
#include <sys/resource.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define IS_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define IS_SANITIZED
#endif
#endif

enum { MOST = 40 };

struct seen {
    atomic_int count[MOST];
    atomic_int wrong;
    int threads;
};

static void count(int number, int threads, void *shared) {
    struct seen *seen = shared;
    sigset_t blocked;
    if (threads != seen->threads || number < 0 || number >= threads)
        atomic_fetch_add(&seen->wrong, 1);
    pthread_sigmask(SIG_SETMASK, NULL, &blocked);
    if (number > 0 && (!sigismember(&blocked, SIGALRM) || !redcc_region_is_nested()))
        atomic_fetch_add(&seen->wrong, 1);
    if (number > 0 && sigismember(&blocked, SIGSEGV))
        atomic_fetch_add(&seen->wrong, 1);
    atomic_fetch_add(&seen->count[number], 1);
}

static int prepare_with(int threads, size_t stack) {
    const uint64_t before = redcc_signals_hold();
    const int there = redcc_pool_prepare(threads, stack);
    redcc_signals_release(before);
    return there;
}

static int prepare(int threads) {
    return prepare_with(threads, 256 * 1024);
}

/* Returns 1 if each thread of a region did its work once. */
static int has_worked(int threads) {
    struct seen seen = {.threads = threads};
    redcc_pool_run(threads, count, &seen);
    for (int t = 0; t < MOST; t++)
        if (atomic_load(&seen.count[t]) != (t < threads))
            return 0;
    return atomic_load(&seen.wrong) == 0;
}

static int tasks(void) {
    int found = 0;
    DIR *folder = opendir("/proc/self/task");
    for (const struct dirent *entry; folder && (entry = readdir(folder));)
        found += entry->d_name[0] != '.';
    if (folder)
        closedir(folder);
    return found;
}

static void regions_of_several_sizes(void **state) {
    static const int sizes[] = {2, 7, 3, 33, 1, 16, 2, 33};
    (void)state;
    assert_true(redcc_region_is_own());
    assert_int_equal(prepare(2), 2);
    assert_true(has_worked(2));
    /* sanitizers start a thread together with the program's first one */
    const int others = tasks() - 2;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        assert_int_equal(prepare(sizes[s]), sizes[s]);
        for (int round = 0; round < 50; round++)
            assert_true(has_worked(sizes[s]));
    }
    assert_int_equal(redcc_pool_threads(), 33);
    assert_int_equal(tasks(), others + 33);
}

static void *work_apart(void *result) {
    int *good = result;
    *good = redcc_pool_threads() == 1 && prepare(4) == 4;
    for (int round = 0; round < 100; round++)
        *good = *good && has_worked(2 + round % 3);
    return NULL;
}

/* Each program thread that executes loops has pool threads of its own, which end with it. */
static void threads_of_several_threads(void **state) {
    enum { CALLERS = 5 };
    (void)state;
    const int before = tasks();
    for (int round = 0; round < 3; round++) {
        pthread_t caller[CALLERS];
        int good[CALLERS];
        for (int c = 0; c < CALLERS; c++)
            assert_int_equal(pthread_create(&caller[c], NULL, work_apart, &good[c]), 0);
        for (int c = 0; c < CALLERS; c++) {
            pthread_join(caller[c], NULL);
            assert_true(good[c]);
        }
    }
    for (int wait = 0; wait < 2000 && tasks() > before; wait++)
        usleep(1000);
    assert_int_equal(tasks(), before);
}

/* The system refuses threads, which must not be an error. */
static void *be_refused(void *result) {
    struct rlimit before, none;
    getrlimit(RLIMIT_AS, &before);
    none = before;
    none.rlim_cur = 1 << 20; /* less memory than the process uses */
    const int first = prepare(2);
    setrlimit(RLIMIT_AS, &none);
    const int refused = prepare_with(9, 64 << 20); /* large enough that no cached stack fits */
    setrlimit(RLIMIT_AS, &before);
    *(int *)result = first == 2 && refused >= 2 && refused < 9 && has_worked(refused) &&
                     prepare(9) == 9 && has_worked(9);
    return NULL;
}

static void threads_that_are_refused(void **state) {
    pthread_t caller;
    int good = 0;
    (void)state;
#ifdef IS_SANITIZED
    skip(); /* sanitizers need the memory */
#endif
    assert_int_equal(pthread_create(&caller, NULL, be_refused, &good), 0);
    pthread_join(caller, NULL);
    assert_true(good);
}

static atomic_int handled_by; /* 1 if the program's first thread handled the signal */
static pthread_t first;
static void handle(int number) {
    (void)number;
    atomic_store(&handled_by, pthread_equal(pthread_self(), first) ? 1 : 2);
}

/* A signal to the process must reach the program's own thread. */
static void signals_of_the_program(void **state) {
    (void)state;
    first = pthread_self();
    signal(SIGUSR1, handle);
    for (int round = 0; round < 20; round++) {
        atomic_store(&handled_by, 0);
        kill(getpid(), SIGUSR1);
        assert_true(has_worked(7));
        assert_int_equal(atomic_load(&handled_by), 1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(regions_of_several_sizes), cmocka_unit_test(threads_of_several_threads),
        cmocka_unit_test(threads_that_are_refused), cmocka_unit_test(signals_of_the_program)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
