/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The number of threads that a round gets (team.h), on a simulated machine: its clock advances only
 * in rounds, and a table gives the speed-up of each number of threads. */
#include <stdlib.h>

#include "check.h"
#include "step/team.h"

typedef struct machine {
    double speed[TEAM_LEVELS]; /* speed-up of each level over one thread */
    double seconds, lost;      /* total of all rounds; its excess over the best level's total */
    unsigned random;
    int noise;   /* if set, rounds take up to a fifth longer */
    int changes; /* if set, ten rounds of 30 have more work */
    int round;
} machine;

enum { PHASES = 4 };

/* A round with one thread takes 2 ms, and 0.1 ms per iteration. */
static void take_round(team *t, machine *m, long iterations) {
    double best = 0, now = m->seconds, solve = 0;
    for (int l = 0; l < t->levels; l++)
        if (m->speed[l] > best)
            best = m->speed[l];
    const double others = m->changes && m->round++ % 30 < 10 ? 12e-3 : 2e-3;
    const double start = now, whole = others + 1e-4 * (double)iterations;
    team_begin(t, now);
    for (int k = 0; k < PHASES; k++) {
        const double alone = k == 2 ? 1e-4 * (double)iterations : others / (PHASES - 1);
        const int level = t->ended ? t->level : t->trial;
        m->random = m->random * 1103515245 + 12345;
        const double noise = m->noise ? 1 + 0.2 * ((m->random >> 16) % 1000) / 1000 : 1;
        const double took = alone / m->speed[level] * noise;
        now += took;
        solve += k == 2 ? took : 0;
        team_check(t, now);
    }
    const team_round round = {now - start, solve, iterations};
    team_end(t, &round);
    m->seconds = now;
    m->lost += now - start - whole / best;
}

static void take_rounds(team *t, machine *m, int count) {
    for (int k = 0; k < count; k++)
        take_round(t, m, 20 + k % 7 * 5);
}

static void one_thread_leaves_nothing_to_choose(void **state) {
    (void)state;
    for (int most = 0; most < 2; most++) {
        team t;
        team_start(&t, most, 1);
        team_begin(&t, 0);
        team_check(&t, 1);
        const team_round round = {1, 0.5, 3};
        team_end(&t, &round);
        assert_int_equal(team_threads(&t), 0);
    }
}

static void free_cores_are_all_used(void **state) {
    (void)state;
    for (int noise = 0; noise < 2; noise++) {
        machine m = {.speed = {3.2, 2.6, 1.8, 1}, .noise = noise, .random = 7};
        team t;
        team_start(&t, 8, 0);
        assert_int_equal(team_threads(&t), 8);
        take_rounds(&t, &m, 300);
        assert_int_equal(team_threads(&t), 8);
        assert_true(noise || m.lost < 0.03 * m.seconds);
    }
}

static void the_fastest_count_is_found(void **state) {
    (void)state;
    machine m = {.speed = {1.2, 1.4, 1.5, 1.3, 1}}; /* 16, 8, 4, 2 and 1 threads */
    team t;
    team_start(&t, 16, 0);
    take_rounds(&t, &m, 200);
    assert_int_equal(team_threads(&t), 4);
    m.speed[1] = 2.5; /* now 8 threads are fastest */
    take_rounds(&t, &m, 200);
    assert_int_equal(team_threads(&t), 8);
    m.speed[1] = 1.4; /* now 8 threads are slower than 4 */
    m.speed[3] = 1.8; /* and 2 threads are fastest */
    take_rounds(&t, &m, 600);
    assert_int_equal(team_threads(&t), 2);
    m.speed[3] = 1.3;
    team_start(&t, 16, 1); /* starts again from one thread */
    assert_int_equal(team_threads(&t), 1);
    take_rounds(&t, &m, 200);
    assert_int_equal(team_threads(&t), 4);
}

static void beside_neighbours_one_thread_is_kept(void **state) {
    (void)state;
    machine m = {.speed = {0.05, 1}};
    team t;
    team_start(&t, 2, 1);
    for (int rounds = 10; rounds <= 1000; rounds *= 10) {
        m.seconds = m.lost = 0;
        take_rounds(&t, &m, rounds);
        assert_int_equal(team_threads(&t), 1);
        /* a fiftieth, and the first trial: one phase of 2 to 5 ms per round */
        assert_true(m.lost < 0.02 * m.seconds + 0.06);
    }
}

static void neighbours_that_come_and_go_are_noticed(void **state) {
    (void)state;
    machine m = {.speed = {1.9, 1}};
    team t;
    team_start(&t, 2, 0);
    take_rounds(&t, &m, 50);
    assert_int_equal(team_threads(&t), 2);
    m.speed[0] = 0.1; /* other programs use the cores */
    m.lost = 0;
    take_rounds(&t, &m, 5);
    assert_int_equal(team_threads(&t), 1);
    assert_true(m.lost < 0.2);
    take_rounds(&t, &m, 200);
    assert_int_equal(team_threads(&t), 1);
    m.speed[0] = 1.9; /* the other programs end */
    take_rounds(&t, &m, 400);
    assert_int_equal(team_threads(&t), 2);
}

/* Rounds with more work are no reason to use fewer threads, and a trial in a round with less work
 * is none either. */
static void work_that_changes_is_no_reason(void **state) {
    (void)state;
    for (int first = 0; first < 30; first++) {
        machine m = {.speed = {1.7, 1}, .changes = 1, .round = first};
        team t;
        team_start(&t, 2, 0);
        for (int k = 0; k < 300; k++) {
            take_rounds(&t, &m, 1);
            assert_int_equal(team_threads(&t), 2);
        }
        assert_true(m.lost < 0.04 * m.seconds);
    }
}

static void a_count_that_is_no_power_of_two(void **state) {
    (void)state;
    machine m = {.speed = {0.5, 0.9, 1}}; /* 7, 3 and 1 threads */
    team t;
    team_start(&t, 7, 0);
    assert_int_equal(t.levels, 3);
    take_rounds(&t, &m, 60);
    assert_int_equal(team_threads(&t), 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_thread_leaves_nothing_to_choose),
        cmocka_unit_test(free_cores_are_all_used),
        cmocka_unit_test(the_fastest_count_is_found),
        cmocka_unit_test(beside_neighbours_one_thread_is_kept),
        cmocka_unit_test(neighbours_that_come_and_go_are_noticed),
        cmocka_unit_test(work_that_changes_is_no_reason),
        cmocka_unit_test(a_count_that_is_no_power_of_two),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
