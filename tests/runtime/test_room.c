/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Whoever waits for threads that OpenMP starts is moved out of their way, and nothing is left of
 * it. */
#define _GNU_SOURCE
#include "base/clock.h"
#include "base/cores.h"
#include "base/room.h"
#include "thread_count.h"

#include <errno.h>
#include <omp.h>
#include <pthread.h>
#include <sched.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <cmocka.h>

/* room.o is linked with these in the place of pthread_create and pthread_join, and of what says
 * that the processors are wanted (CMakeLists.txt). */
int __real_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                          void *given);
int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                          void *given);

bool __wrap_redcc_cores_are_wanted(int more);

int __real_pthread_join(pthread_t thread, void **result);
int __wrap_pthread_join(pthread_t thread, void **result);

static int created, joined, refused;
static bool wanted;

bool __wrap_redcc_cores_are_wanted(int more) {
    return wanted && more > 0;
}

int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                          void *given) {
    created++;
    return refused ? EAGAIN : __real_pthread_create(thread, attributes, run, given);
}

int __wrap_pthread_join(pthread_t thread, void **result) {
    joined++;
    return __real_pthread_join(thread, result);
}

static int threads; /* at first: a sanitizer has its own */

/* A thread that has ended counts until the system has cleared it away. */
static void assert_none_is_left(void) {
    assert_int_equal(joined, created);
    const double until = redcc_seconds() + 5;
    while (count_threads() > threads && redcc_seconds() < until)
        sched_yield();
    assert_int_equal(count_threads(), threads);
}

static cpu_set_t allowed(void) {
    cpu_set_t set;
    assert_int_equal(sched_getaffinity(0, sizeof set, &set), 0);
    return set;
}

static bool is_taken(struct cores *cores, int core) {
    const size_t bits = 8 * sizeof *cores->taken;
    return atomic_load(&cores->taken[(size_t)core / bits]) >> (size_t)core % bits & 1;
}

static void wait_for(double seconds) {
    const double until = redcc_seconds() + seconds;
    while (redcc_seconds() < until)
        ;
}

/* Only where OpenMP's library has the one that asks wait, and there is another processor. */
static void begin_or_skip(struct room *room, struct cores *cores) {
    redcc_cores_begin(cores);
    redcc_room_begin(room, cores, 1);
    if (!room->is_helped)
        skip();
}

static void who_waits_is_moved(void **state) {
    (void)state;
    created = joined = 0;
    const cpu_set_t all = allowed();
    struct cores cores;
    struct room room;
    begin_or_skip(&room, &cores);
    assert_true(is_taken(&cores, room.core));
    const double until = redcc_seconds() + 5; /* the helper may have to wait for its turn */
    while (is_taken(&cores, room.core) && redcc_seconds() < until)
        ;
    redcc_room_end(&room);
    assert_false(is_taken(&cores, room.core)); /* who is started there may stay */
    int taken = 0;
    for (int core = 0; core < 1024; core++)
        taken += is_taken(&cores, core);
    assert_int_equal(taken, 1); /* where it is now */
    const cpu_set_t after = allowed();
    assert_true(CPU_EQUAL(&all, &after));
    assert_none_is_left();
}

/* The system may keep the helper back, but not always. */
static void who_need_not_wait_stays(void **state) {
    (void)state;
    created = joined = 0;
    int stays = 0;
    for (int i = 0; i < 50 && stays == 0; i++) {
        struct cores cores;
        struct room room;
        begin_or_skip(&room, &cores);
        redcc_room_end(&room);
        stays += is_taken(&cores, room.core);
        redcc_room_end(&room); /* has nothing more to do */
    }
    assert_int_equal(stays, 1);
    assert_none_is_left();
}

static void there_may_be_no_thread_for_it(void **state) {
    (void)state;
    struct cores cores;
    struct room room;
    created = 0;
    refused = 1;
    redcc_cores_begin(&cores);
    redcc_room_begin(&room, &cores, 1);
    refused = 0;
    assert_false(room.is_helped);
    wait_for(1e-3);
    redcc_room_end(&room);
    assert_true(is_taken(&cores, room.core));
}

/* OpenMP may need the last one. */
static void where_threads_are_few_none_is_taken(void **state) {
    (void)state;
    struct cores cores;
    struct room room;
    struct rlimit before;
    assert_int_equal(getrlimit(RLIMIT_NPROC, &before), 0);
    const rlim_t few = before.rlim_max < 1000 ? before.rlim_max : 1000;
    const struct rlimit limit = {few, before.rlim_max};
    assert_int_equal(setrlimit(RLIMIT_NPROC, &limit), 0);
    created = 0;
    redcc_cores_begin(&cores);
    redcc_room_begin(&room, &cores, 1);
    assert_int_equal(setrlimit(RLIMIT_NPROC, &before), 0);
    assert_false(room.is_helped);
    assert_int_equal(created, 0);
    redcc_room_end(&room);
}

/* The region would have to wait for the helper's turn. */
static void where_processors_are_wanted_none_is_taken(void **state) {
    (void)state;
    struct cores cores;
    struct room room;
    created = 0;
    wanted = true;
    redcc_cores_begin(&cores);
    redcc_room_begin(&room, &cores, 1);
    wanted = false;
    assert_false(room.is_helped);
    assert_int_equal(created, 0);
}

static void where_none_is_started_nothing_is_done(void **state) {
    (void)state;
    struct cores cores;
    struct room room = {.is_helped = true};
    created = 0;
    redcc_cores_begin(&cores);
    redcc_room_begin(&room, &cores, 0);
    assert_false(room.is_helped);
    assert_int_equal(created, 0);
}

static void where_there_is_one_processor_nothing_is_done(void **state) {
    (void)state;
    const cpu_set_t all = allowed();
    cpu_set_t one;
    struct cores cores;
    struct room room;
    CPU_ZERO(&one);
    CPU_SET((size_t)sched_getcpu(), &one);
    assert_int_equal(sched_setaffinity(0, sizeof one, &one), 0);
    redcc_cores_begin(&cores);
    redcc_room_begin(&room, &cores, 1);
    assert_int_equal(sched_setaffinity(0, sizeof all, &all), 0);
    assert_false(room.is_helped);
    redcc_room_end(&room);
}

/* Regions begin with it, and have all their threads. Last: OpenMP keeps them. */
static void a_region_begins(void **state) {
    (void)state;
    struct cores cores;
    struct room room;
    int came = 0;
    redcc_cores_begin(&cores);
    redcc_room_begin(&room, &cores, 1);
#pragma omp parallel num_threads(3) reduction(+ : came)
    {
        if (omp_get_thread_num() == 0)
            redcc_room_end(&room);
        came++;
    }
    assert_int_equal(came, 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(who_waits_is_moved),
        cmocka_unit_test(who_need_not_wait_stays),
        cmocka_unit_test(there_may_be_no_thread_for_it),
        cmocka_unit_test(where_threads_are_few_none_is_taken),
        cmocka_unit_test(where_processors_are_wanted_none_is_taken),
        cmocka_unit_test(where_none_is_started_nothing_is_done),
        cmocka_unit_test(where_there_is_one_processor_nothing_is_done),
        cmocka_unit_test(a_region_begins),
    };
    threads = count_threads();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
