/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Threads of a region that were put on one processor part; where they may run is as before. */
#define _GNU_SOURCE
#include "base/affinity.h"
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

/*
 * A machine whose processors are numbers, where threads move when the test says so and no earlier:
 * on a real one the system may move a thread whenever it likes. cores.o is linked with these
 * functions in the place of the system's (CMakeLists.txt). Without a machine they are the system's.
 */
struct machine {
    int at;         /* where the calling thread is */
    int processors; /* it may run on 0 to this */
    int leaves;     /* how often it was told to go elsewhere */
    bool stubborn;  /* each time it is taken back before it looks where it is */
};

static _Thread_local struct machine *machine;

int __real_redcc_system_core(void);
int __wrap_redcc_system_core(void);
bool __real_redcc_processors_leave(const unsigned long *taken, size_t words);
bool __wrap_redcc_processors_leave(const unsigned long *taken, size_t words);

int __wrap_redcc_system_core(void) {
    return machine ? machine->at : __real_redcc_system_core();
}

static bool is_in(const unsigned long *set, size_t words, int core) {
    const size_t bits = 8 * sizeof *set;
    return (size_t)core / bits < words && (set[(size_t)core / bits] >> (size_t)core % bits & 1);
}

bool __wrap_redcc_processors_leave(const unsigned long *taken, size_t words) {
    if (!machine)
        return __real_redcc_processors_leave(taken, words);
    machine->leaves++;
    for (int core = 0; core < machine->processors; core++)
        if (!is_in(taken, words, core)) {
            machine->at = machine->stubborn ? machine->at : core;
            return true;
        }
    return false;
}

static bool is_taken(struct cores *cores, int core) {
    unsigned long taken[sizeof cores->taken / sizeof *cores->taken];
    for (size_t w = 0; w < sizeof taken / sizeof *taken; w++)
        taken[w] = atomic_load(&cores->taken[w]);
    return is_in(taken, sizeof taken / sizeof *taken, core);
}

/* What a new thread does on such a machine: who has just moved does not move again at once. */
struct script {
    struct machine machine;
    struct cores cores;
    int come; /* threads, to who began the region and waits for one */
};

static void *run_take(void *given) {
    struct script *script = given;
    machine = &script->machine;
    redcc_cores_take(&script->cores);
    return NULL;
}

static void *run_give_way(void *given) {
    struct script *script = given;
    machine = &script->machine;
    redcc_cores_begin(&script->cores);
    atomic_store(&script->cores.come, script->come);
    redcc_cores_give_way(&script->cores, 1);
    return NULL;
}

static void in_a_new_thread(void *run(void *), void *given) {
    pthread_t other;
    assert_int_equal(pthread_create(&other, NULL, run, given), 0);
    assert_int_equal(pthread_join(other, NULL), 0);
}

static void begin_on(struct script *script, int core) {
    struct machine host = {.at = core};
    machine = &host;
    redcc_cores_begin(&script->cores);
    machine = NULL;
}

static void who_comes_to_a_taken_processor_moves(void **state) {
    (void)state;
    struct script script = {.machine = {.at = 0, .processors = 4}};
    begin_on(&script, 0);
    for (int core = 1; core < 4; core++) { /* three come to where the first one is */
        script.machine.at = 0;
        in_a_new_thread(run_take, &script);
        assert_int_equal(script.machine.at, core);
        assert_int_equal(script.machine.leaves, core);
        assert_true(is_taken(&script.cores, core));
        assert_int_equal(atomic_load(&script.cores.come), core);
    }
    script.machine.at = 0; /* a fourth finds no room, and stays */
    in_a_new_thread(run_take, &script);
    assert_int_equal(script.machine.at, 0);
    assert_int_equal(atomic_load(&script.cores.come), 4);
}

static void who_comes_to_a_free_processor_stays(void **state) {
    (void)state;
    struct script script = {.machine = {.at = 2, .processors = 4}};
    begin_on(&script, 0);
    in_a_new_thread(run_take, &script);
    assert_int_equal(script.machine.at, 2);
    assert_int_equal(script.machine.leaves, 0);
    assert_true(is_taken(&script.cores, 2));
    assert_false(is_taken(&script.cores, 1));
}

/* Where more processors are than the set has room for, nobody moves. */
static void who_is_beyond_the_set_stays(void **state) {
    (void)state;
    const int beyond[] = {-1, 1024, 5000};
    for (size_t i = 0; i < sizeof beyond / sizeof *beyond; i++) {
        struct script script = {.machine = {.at = beyond[i], .processors = 4}};
        begin_on(&script, beyond[i]);
        in_a_new_thread(run_take, &script);
        in_a_new_thread(run_give_way, &script);
        assert_int_equal(script.machine.leaves, 0);
    }
}

/* As where the system wakes a thread on the waker's processor each time. */
struct waking {
    struct script script;
    int moves;
    double seconds; /* that they took */
};

static void *come_back(void *given) {
    struct waking *waking = given;
    struct script *script = &waking->script;
    machine = &script->machine;
    const double begun = redcc_seconds();
    for (int i = 0; i < 2000; i++) {
        machine->at = 0;
        redcc_cores_begin(&script->cores); /* in the place of the one that begins the region */
        redcc_cores_take(&script->cores);
        waking->moves += machine->at != 0;
    }
    waking->seconds = redcc_seconds() - begun;
    return NULL;
}

static void who_is_taken_back_does_not_move_at_once(void **state) {
    (void)state;
    struct waking waking = {.script.machine.processors = 2};
    in_a_new_thread(come_back, &waking);
    assert_in_range(waking.moves, 1, 1 + (int)(waking.seconds / 2e-3));
}

static void who_waits_in_vain_gives_way(void **state) {
    (void)state;
    struct script script = {.machine = {.at = 0, .processors = 2}};
    in_a_new_thread(run_give_way, &script);
    assert_int_equal(script.machine.at, 1);
    assert_int_equal(script.machine.leaves, 1);
    assert_true(is_taken(&script.cores, 1));
    assert_false(is_taken(&script.cores, 0)); /* who is waited for may stay there */
}

static void who_is_taken_back_at_once_is_where_it_was(void **state) {
    (void)state;
    struct script script = {.machine = {.at = 0, .processors = 2, .stubborn = true}};
    in_a_new_thread(run_give_way, &script);
    assert_int_equal(script.machine.at, 0);
    assert_true(is_taken(&script.cores, 0));
    assert_false(is_taken(&script.cores, 1));
}

static void who_need_not_wait_stays(void **state) {
    (void)state;
    struct script script = {.machine = {.at = 0, .processors = 2}, .come = 1};
    in_a_new_thread(run_give_way, &script);
    assert_int_equal(script.machine.at, 0);
    assert_int_equal(script.machine.leaves, 0);
    assert_true(is_taken(&script.cores, 0));
}

/* The system itself. It may take the thread back before it says where it is, but not always. */
static void a_thread_leaves_a_processor(void **state) {
    const cpu_set_t *all = *state;
    bool moved = false;
    for (int i = 0; i < 1000 && !moved; i++) {
        const int core = sched_getcpu();
        unsigned long taken[1024 / (8 * sizeof(unsigned long))] = {0};
        const size_t bits = 8 * sizeof *taken;
        if (core < 0 || core >= 1024)
            skip();
        taken[(size_t)core / bits] = 1ul << (size_t)core % bits;
        stay_on(core);
        sched_setaffinity(0, sizeof *all, all); /* which moves nobody */
        assert_int_equal(redcc_processors_leave(taken, sizeof taken / sizeof *taken),
                         CPU_COUNT(all) > 1);
        moved = sched_getcpu() != core;
        const cpu_set_t after = allowed();
        assert_true(CPU_EQUAL(&after, all)); /* where it may run is as before */
    }
    assert_int_equal(moved, CPU_COUNT(all) > 1);
}

static void who_may_run_nowhere_else_stays(void **state) {
    (void)state;
    const int core = sched_getcpu();
    struct cores cores;
    stay_on(core);
    redcc_cores_begin(&cores);
    redcc_cores_take(&cores); /* as one that comes */
    assert_int_equal(sched_getcpu(), core);
    const cpu_set_t before = set_of(core), after = allowed();
    assert_true(CPU_EQUAL(&after, &before));
    assert_int_equal(atomic_load(&cores.come), 1);
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
#else
    assert_false(redcc_has_avx2());
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
    if (access("/proc/loadavg", R_OK) != 0)
        skip(); /* not known here */
    assert_true(redcc_system_running() > 0);
    assert_int_equal(online, sysconf(_SC_NPROCESSORS_ONLN));
    if (online != redcc_processors_here() || count > MOST)
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
        cmocka_unit_test(who_comes_to_a_taken_processor_moves),
        cmocka_unit_test(who_comes_to_a_free_processor_stays),
        cmocka_unit_test(who_is_beyond_the_set_stays),
        cmocka_unit_test(who_is_taken_back_does_not_move_at_once),
        cmocka_unit_test(who_waits_in_vain_gives_way),
        cmocka_unit_test(who_is_taken_back_at_once_is_where_it_was),
        cmocka_unit_test(who_need_not_wait_stays),
        cmocka_unit_test_prestate_setup_teardown(a_thread_leaves_a_processor, NULL, restore, given),
        cmocka_unit_test_prestate_setup_teardown(who_may_run_nowhere_else_stays, NULL, restore,
                                                 given),
        cmocka_unit_test_prestate_setup_teardown(each_region_begins_anew, NULL, restore, given),
        cmocka_unit_test(the_processor_is_what_the_compiler_finds),
        cmocka_unit_test(threads_that_would_wait_are_foreseen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
