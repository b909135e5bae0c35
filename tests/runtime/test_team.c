/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The number of threads that OpenMP must start, since the program may have started some for other
 * regions. Also: whether other programs use the processors. */
#include "base/team.h"

#include "base/clock.h"
#include "base/system.h"
#include "thread_count.h"

#include <omp.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <unistd.h>

#include <cmocka.h>

enum { THREADS = 3 };

static int to_start;

static void *ask(void *unused) {
    (void)unused;
    to_start = redcc_team_to_start(THREADS);
    return NULL;
}

static int asked_by_another_thread(void) {
    pthread_t thread;
    assert_int_equal(pthread_create(&thread, NULL, ask, NULL), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    return to_start;
}

static int begin_region(int threads) {
    int came = 0;
#pragma omp parallel num_threads(threads)
#pragma omp single
    came = omp_get_num_threads();
    return came;
}

/* The order of these checks matters, since OpenMP keeps threads that it has started. */
static void threads_that_are_there_need_not_be_started(void **state) {
    (void)state;
    if (count_threads() >= THREADS) /* ThreadSanitizer has threads of its own */
        skip();
    assert_int_equal(redcc_team_to_start(1), 0);
    assert_int_equal(redcc_team_to_start(THREADS), THREADS - 1);
    redcc_team_begun(1); /* a region of one thread */
    assert_int_equal(redcc_team_to_start(THREADS), THREADS - 1);
    if (begin_region(THREADS) < THREADS)
        skip();
    /* the thread that asked first still gets the same result */
    assert_int_equal(redcc_team_missing(THREADS), THREADS - 1);
    assert_int_equal(redcc_team_to_start(THREADS), 0);
    const int too_many = count_threads() + 1;
    assert_int_equal(redcc_team_to_start(too_many), too_many - 1);
    /* each thread has its own count */
    assert_int_equal(asked_by_another_thread(), THREADS - 1);
    redcc_team_begun(THREADS);
    assert_int_equal(redcc_team_missing(THREADS), 0);
    assert_int_equal(redcc_team_to_start(THREADS + 2), 2);
}

static atomic_bool over;

static void *compute(void *unused) {
    while (!atomic_load(&over))
        ;
    return unused;
}

/* Slightly more threads compute than there are processors. */
static void threads_that_run_are_counted(void **unused) {
    (void)unused;
    enum { MOST = 512 };
    static pthread_t thread[MOST];
    const int online = redcc_system_online(), count = online + 6;
    if (access("/proc/loadavg", R_OK) != 0 || count > MOST)
        skip(); /* not known here */
    assert_true(redcc_system_running() > 0);
    assert_int_equal(online, sysconf(_SC_NPROCESSORS_ONLN));
    for (int i = 0; i < count; i++)
        assert_int_equal(pthread_create(&thread[i], NULL, compute, NULL), 0);
    const double until = redcc_seconds() + 10;
    int running = 0; /* reaches at least `count` once all threads have begun */
    while (running <= count && redcc_seconds() < until)
        running = redcc_system_running();
    atomic_store(&over, true);
    for (int i = 0; i < count; i++)
        pthread_join(thread[i], NULL);
    assert_in_range(running, count + 1, 10000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_that_are_there_need_not_be_started),
        cmocka_unit_test(threads_that_run_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
