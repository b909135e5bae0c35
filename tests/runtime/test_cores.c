/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Threads of a region that were put on one processor part; where they may run is as before. */
#define _GNU_SOURCE
#include "base/clock.h"
#include "base/cores.h"
#include "base/processor.h"
#include "base/system.h"

#include <pthread.h>
#include <sched.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <unistd.h>

#include <cmocka.h>

static cpu_set_t set_of(int core) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET((size_t)core, &set);
    return set;
}

static cpu_set_t allowed(void) {
    cpu_set_t set;
    assert_int_equal(sched_getaffinity(0, sizeof set, &set), 0);
    return set;
}

static void stay_on(int core) {
    const cpu_set_t set = set_of(core);
    assert_int_equal(sched_setaffinity(0, sizeof set, &set), 0);
}

struct visit {
    struct cores cores;
    int host;         /* where the one that begins the region is */
    cpu_set_t before; /* where the other may run when it comes, */
    cpu_set_t after;  /* and later */
    int core;         /* where it ends up */
    int moves;
    double seconds; /* that they took */
};

static void *come(void *given) {
    struct visit *visit = given;
    stay_on(visit->host);
    sched_setaffinity(0, sizeof visit->before, &visit->before); /* which moves nobody */
    redcc_cores_take(&visit->cores);
    visit->core = sched_getcpu();
    visit->after = allowed();
    return NULL;
}

static struct visit visit_of(cpu_set_t before) {
    static struct visit visit;
    pthread_t other;
    visit = (struct visit){.host = sched_getcpu(), .before = before};
    stay_on(visit.host);
    redcc_cores_begin(&visit.cores);
    assert_int_equal(pthread_create(&other, NULL, come, &visit), 0);
    assert_int_equal(pthread_join(other, NULL), 0);
    return visit;
}

static void who_comes_to_a_taken_processor_moves(void **state) {
    const cpu_set_t *all = *state;
    enum { VISITS = 20 };
    int stayed = 0; /* the system may take a thread back before it says where it is */
    for (int i = 0; i < VISITS; i++) {
        const struct visit visit = visit_of(*all);
        stayed += visit.core == visit.host;
        assert_true(CPU_EQUAL(&visit.after, all));
    }
    if (CPU_COUNT(all) > 1)
        assert_in_range(stayed, 0, VISITS / 4);
}

/* As where the system wakes a thread on the waker's processor each time. */
static void *come_back(void *given) {
    struct visit *visit = given;
    const double begun = redcc_seconds();
    for (int i = 0; i < 2000; i++) {
        stay_on(visit->host);
        redcc_cores_begin(&visit->cores); /* in the place of the one that begins the region */
        sched_setaffinity(0, sizeof visit->before, &visit->before);
        redcc_cores_take(&visit->cores);
        visit->moves += sched_getcpu() != visit->host;
    }
    visit->seconds = redcc_seconds() - begun;
    return NULL;
}

static void who_is_taken_back_does_not_move_at_once(void **state) {
    const cpu_set_t *all = *state;
    struct visit visit = {.host = sched_getcpu(), .before = *all};
    pthread_t other;
    assert_int_equal(pthread_create(&other, NULL, come_back, &visit), 0);
    assert_int_equal(pthread_join(other, NULL), 0);
    if (CPU_COUNT(all) > 1)
        assert_in_range(visit.moves, 1, 1 + (int)(visit.seconds / 2e-3));
}

static void who_may_run_nowhere_else_stays(void **state) {
    (void)state;
    const struct visit visit = visit_of(set_of(sched_getcpu()));
    const cpu_set_t host = set_of(visit.host);
    assert_int_equal(visit.core, visit.host);
    assert_true(CPU_EQUAL(&visit.after, &host));
}

/* As if all others were taken. */
static void who_finds_all_processors_taken_stays(void **state) {
    struct cores cores;
    const cpu_set_t *all = *state;
    stay_on(sched_getcpu());
    const int host = sched_getcpu();
    redcc_cores_begin(&cores);
    for (size_t w = 0; w < sizeof cores.taken / sizeof *cores.taken; w++)
        atomic_store(&cores.taken[w], ~0ul);
    redcc_cores_take(&cores);
    const cpu_set_t before = set_of(host), after = allowed();
    assert_true(CPU_EQUAL(&after, &before));
    assert_true(CPU_ISSET((size_t)host, all));
}

static bool is_taken(struct cores *cores, int core) {
    const size_t bits = 8 * sizeof *cores->taken;
    return atomic_load(&cores->taken[(size_t)core / bits]) >> (size_t)core % bits & 1;
}

struct wait {
    cpu_set_t all;
    int come; /* of one */
    int host, core;
    bool host_is_taken, core_is_taken;
    cpu_set_t after;
};

static void *begin_region(void *given) {
    static struct cores cores;
    struct wait *wait = given;
    wait->host = sched_getcpu();
    stay_on(wait->host);
    redcc_cores_begin(&cores);
    sched_setaffinity(0, sizeof wait->all, &wait->all);
    atomic_store(&cores.come, wait->come);
    redcc_cores_give_way(&cores, 1);
    wait->core = sched_getcpu();
    wait->host_is_taken = is_taken(&cores, wait->host);
    wait->core_is_taken = is_taken(&cores, wait->core);
    wait->after = allowed();
    return NULL;
}

static struct wait wait_of(const cpu_set_t *all, int come) {
    static struct wait wait;
    pthread_t first;
    wait = (struct wait){.all = *all, .come = come};
    assert_int_equal(pthread_create(&first, NULL, begin_region, &wait), 0);
    assert_int_equal(pthread_join(first, NULL), 0);
    return wait;
}

static void who_waits_in_vain_gives_way(void **state) {
    const cpu_set_t *all = *state;
    int stays = 0;
    for (int i = 0; i < 20; i++) {
        const struct wait wait = wait_of(all, 0);
        assert_true(CPU_EQUAL(&wait.after, all));
        if (wait.core == wait.host) { /* the system has taken it back, perhaps */
            stays++;
            continue;
        }
        assert_true(wait.core_is_taken);
        assert_false(wait.host_is_taken);
    }
    assert_in_range(stays, CPU_COUNT(all) > 1 ? 0 : 20, CPU_COUNT(all) > 1 ? 5 : 20);
}

static void who_need_not_wait_stays(void **state) {
    int moves = 0;
    for (int i = 0; i < 20; i++) {
        const struct wait wait = wait_of(*state, 1);
        moves += wait.core != wait.host; /* by the system, perhaps */
    }
    assert_in_range(moves, 0, 5);
}

static void each_region_begins_anew(void **state) {
    (void)state;
    struct cores cores;
    for (size_t w = 0; w < sizeof cores.taken / sizeof *cores.taken; w++)
        atomic_store(&cores.taken[w], ~0ul);
    stay_on(sched_getcpu());
    atomic_store(&cores.come, 3);
    redcc_cores_begin(&cores);
    assert_int_equal(atomic_load(&cores.come), 0);
    int taken = 0;
    for (size_t w = 0; w < sizeof cores.taken / sizeof *cores.taken; w++)
        taken += __builtin_popcountl(atomic_load(&cores.taken[w]));
    assert_int_equal(taken, sched_getcpu() < 1024);
}

static void the_processor_is_what_the_compiler_finds(void **state) {
    (void)state;
#ifdef __x86_64__
    assert_int_equal(redcc_has_avx2(), __builtin_cpu_supports("avx2") != 0);
    assert_int_equal(redcc_has_avx512(), __builtin_cpu_supports("avx512f") &&
                                             __builtin_cpu_supports("avx512dq") &&
                                             __builtin_cpu_supports("avx512vl"));
#else
    assert_false(redcc_has_avx2() || redcc_has_avx512());
#endif
}

static atomic_bool over;

static void *compute(void *unused) {
    while (!atomic_load(&over))
        ;
    return unused;
}

/* As many threads compute as there are processors, and some more. */
static void threads_that_would_wait_are_foreseen(void **unused) {
    (void)unused;
    enum { MOST = 512 };
    static pthread_t thread[MOST];
    const int online = redcc_system_online(), count = online + 6;
    if (redcc_system_running() == 0)
        skip(); /* not known here */
    assert_int_equal(online, sysconf(_SC_NPROCESSORS_ONLN));
    if (online != redcc_system_processors() || count > MOST)
        skip();
    for (int i = 0; i < count; i++)
        assert_int_equal(pthread_create(&thread[i], NULL, compute, NULL), 0);
    const double until = redcc_seconds() + 10;
    int running = 0; /* all of them, once each has begun */
    while ((running <= count || !redcc_cores_are_wanted(0)) && redcc_seconds() < until)
        running = redcc_system_running();
    const bool wanted = redcc_cores_are_wanted(0), with_fewer = redcc_cores_are_wanted(-10000);
    atomic_store(&over, true);
    for (int i = 0; i < count; i++)
        pthread_join(thread[i], NULL);
    assert_true(wanted);
    assert_false(with_fewer);
    assert_in_range(running, count + 1, 10000);
}

static int restore(void **state) {
    return sched_setaffinity(0, sizeof(cpu_set_t), *state);
}

int main(void) {
    static cpu_set_t all;
    void *given = &all;
    all = allowed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate_setup_teardown(who_comes_to_a_taken_processor_moves, NULL,
                                                 restore, given),
        cmocka_unit_test_prestate_setup_teardown(who_is_taken_back_does_not_move_at_once, NULL,
                                                 restore, given),
        cmocka_unit_test_prestate_setup_teardown(who_may_run_nowhere_else_stays, NULL, restore,
                                                 given),
        cmocka_unit_test_prestate_setup_teardown(who_finds_all_processors_taken_stays, NULL,
                                                 restore, given),
        cmocka_unit_test_prestate_setup_teardown(who_waits_in_vain_gives_way, NULL, restore, given),
        cmocka_unit_test_prestate_setup_teardown(who_need_not_wait_stays, NULL, restore, given),
        cmocka_unit_test_prestate_setup_teardown(each_region_begins_anew, NULL, restore, given),
        cmocka_unit_test(the_processor_is_what_the_compiler_finds),
        cmocka_unit_test(threads_that_would_wait_are_foreseen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
