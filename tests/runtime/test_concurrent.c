/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* One loop in two user threads at once, and inside a parallel region. The loop runs serially and
 * correctly or, by a method with another order, in one thread in that order. */
#include "base/memory.h"
#include "loop.h"
#include "problem.h"
#include "settings.h"

#include <omp.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { CALLS = 30 };

/* Does a plan execute the loop in any case? It does for a method whose order differs from the
 * loop's, and for compensated sums, since the bits must always be the same. */
static bool always_plans(void) {
    const struct settings *settings = redcc_settings();
    return settings->compensated || settings->method->keeps == REDCC_ORDER_FIXED;
}

struct user {
    struct problem problem;
    struct described *described;
    double *expected;
    size_t bytes;
    int wrong;
    long parallel;
};

/* Values are exact or, if the method always gives the same bits, inexact. In that case the expected
 * result is that of three threads. */
static void user_begin(struct user *user, int number, struct described *described) {
    user->problem = problem_new(number, !always_plans());
    user->described = described;
    user->bytes = (size_t)user->problem.doubles * sizeof(double);
    user->expected = malloc(user->bytes);
    if (always_plans()) {
        struct described once;
        long last;
        problem_describe(&user->problem, &once);
        assert_true(problem_run(&user->problem, &once, 3, &last));
        redcc_loop_forget(&once.loop);
    } else
        problem_oracle(&user->problem);
    memcpy(user->expected, user->problem.first, user->bytes);
    user->wrong = 0;
    user->parallel = 0;
}

static void user_end(struct user *user) {
    problem_free(&user->problem);
    free(user->expected);
}

static void *use(void *argument) {
    struct user *user = argument;
    for (int call = 0; call < CALLS; call++) {
        long last;
        problem_reset(&user->problem);
        user->parallel += problem_run(&user->problem, user->described, 2, &last);
        user->wrong += memcmp(user->expected, user->problem.first, user->bytes) != 0;
    }
    return NULL;
}

static long fallbacks(const struct described *described, enum reason reason) {
    const struct loop_state *state = described->loop.state;
    return atomic_load(&state->reported.statistics.fallback[reason]);
}

static void two_user_threads(void **unused) {
    (void)unused;
    struct user users[2];
    struct described described;
    pthread_t threads[2];
    for (int i = 0; i < 2; i++)
        user_begin(&users[i], 0, &described);
    problem_describe(&users[0].problem, &described);
    for (int i = 0; i < 2; i++)
        assert_int_equal(pthread_create(&threads[i], NULL, use, &users[i]), 0);
    for (int i = 0; i < 2; i++)
        pthread_join(threads[i], NULL);
    const long serial = fallbacks(&described, REASON_CONCURRENT);
    assert_int_equal(users[0].wrong + users[1].wrong, 0);
    assert_int_equal(users[0].parallel + users[1].parallel + serial, 2 * CALLS);
    assert_true(serial == 0 || !always_plans());
    assert_true(users[0].parallel + users[1].parallel > 0);
    redcc_loop_forget(&described.loop);
    user_end(&users[0]);
    user_end(&users[1]);
    assert_int_equal(redcc_memory_live(), 0);
}

static void inside_a_region(void **unused) {
    (void)unused;
    struct user users[3];
    struct described described;
    for (int i = 0; i < 3; i++)
        user_begin(&users[i], 2, &described);
    problem_describe(&users[0].problem, &described);
#pragma omp parallel for num_threads(3)
    for (int i = 0; i < 3; i++)
        use(&users[i]);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(users[i].wrong, 0);
        assert_int_equal(users[i].parallel, always_plans() ? CALLS : 0);
        user_end(&users[i]);
    }
    assert_int_equal(fallbacks(&described, REASON_NESTED), always_plans() ? 0 : 3 * CALLS);
    redcc_loop_forget(&described.loop);
    assert_int_equal(redcc_memory_live(), 0);
}

/* OpenMP gives fewer threads than requested. */
static void fewer_threads_than_asked_for(void **unused) {
    (void)unused;
    struct user user;
    struct described described;
    user_begin(&user, 9, &described);
    problem_describe(&user.problem, &described);
    for (int threads = 5; threads >= 1; threads--)
        for (int call = 0; call < 2; call++) {
            long last;
            problem_reset(&user.problem);
            const int parallel = problem_run_fewer(&user.problem, &described, 5, threads, &last);
            assert_int_equal(parallel, threads > 1 || always_plans());
            assert_memory_equal(user.expected, user.problem.first, user.bytes);
        }
    const struct loop_state *state = described.loop.state;
    const int plans = always_plans() ? 5 : 4;
    assert_int_equal(state->reported.statistics.plans_built, plans);
    assert_int_equal(state->reported.statistics.plans_reused, plans);
    assert_int_equal(fallbacks(&described, REASON_ONE_THREAD), always_plans() ? 0 : 2);
    redcc_loop_forget(&described.loop);
    user_end(&user);
    assert_int_equal(redcc_memory_live(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_user_threads),
        cmocka_unit_test(inside_a_region),
        cmocka_unit_test(fewer_threads_than_asked_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
