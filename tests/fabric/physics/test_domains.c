/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The order of the domains' passes: who waits for whom, and that a wait lasts until the pass has
 * ended. */
#include "check.h"

#include <pthread.h>
#include <stdlib.h>
#include <time.h>

#include "cloth.h"
#include "solver/solver_domains_parts.h"

/* Ends pass 1 of the domains 0 and 4, the one `late` after a pause. */
typedef struct other_thread {
    domain_turn turn[5];
    int late;
    int written; /* what the late domain writes */
} other_thread;

static void *end_turns(void *argument) {
    other_thread *of = argument;
    const struct timespec pause = {0, 50000000};
    domain_turn_end(&of->turn[2], 1);
    domain_turn_end(&of->turn[4 - of->late], 1);
    nanosleep(&pause, NULL);
    of->written = 1;
    domain_turn_end(&of->turn[of->late], 1);
    return NULL;
}

static void test_a_domain_awaits_all_neighbours(void **state) {
    (void)state;
    for (int late = 0; late <= 4; late += 4) {
        pthread_t thread;
        other_thread of = {.late = late};
        domain_turn_add_neighbour(&of.turn[1], 4);
        domain_turn_add_neighbour(&of.turn[1], 0);
        domain_turn_add_neighbour(&of.turn[1], 2);
        domain_turns_begin(of.turn, 5);
        assert_int_equal(pthread_create(&thread, NULL, end_turns, &of), 0);
        domain_turn_await(of.turn, 3, 1); /* it has no neighbour */
        domain_turn_await(of.turn, 1, 1);
        assert_int_equal(of.written, 1);
        pthread_join(thread, NULL);
        domain_turns_begin(of.turn, 5);
        assert_int_equal((int)of.turn[0].passes, 0);
    }
}

/* A chain of vertices in five domains. Each domain shares blocks with the next one, and the first
 * shares one with the fourth. */
static void test_neighbours_share_blocks(void **state) {
    (void)state;
    static const int start[] = {0, 2, 4, 6, 8, 10};
    static const int first[] = {1, 0, 1, 0, 3}, last[] = {3, 2, 3, 4, 3};
    int pair[10][2] = {{0, 7}};
    linear_system system;
    for (int i = 1; i < 10; i++) {
        pair[i][0] = i - 1;
        pair[i][1] = i;
    }
    const element_list list = {10, 2, &pair[0][0]};
    assert_int_equal(system_init(&system, 10, 1, &list), 0);
    domain_solver *d = domain_solver_divided(&system.A, 5, start);
    assert_non_null(d);
    for (int k = 0; k < 5; k++) {
        assert_true(d->turn[k].has_any);
        assert_int_equal(d->turn[k].first, first[k]);
        assert_int_equal(d->turn[k].last, last[k]);
    }
    domain_solver_free(d);
    system_free(&system);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_domain_awaits_all_neighbours),
        cmocka_unit_test(test_neighbours_share_blocks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
