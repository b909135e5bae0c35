/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Tests base/crew.h: a task is executed by as many threads as requested, and once by each of
 * them. */
#include "base/crew.h"

#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdlib.h>

#include <cmocka.h>

enum { MOST = 5 };
static atomic_int calls[MOST], wrong;

static void work(int number, int threads, void *asked) {
    if (number < 0 || number >= MOST || threads != *(const int *)asked) {
        atomic_fetch_add(&wrong, 1);
        return;
    }
    atomic_fetch_add(&calls[number], 1);
}

static void work_of_some(redcc_crew *crew) {
    if (redcc_crew_help(crew))
        return;
    const int threads = redcc_crew_threads();
    for (int asked = threads; asked > 1; asked--)
        redcc_crew_run(asked, work, &asked);
    redcc_crew_end(crew);
    if (redcc_crew_threads() != 0)
        atomic_fetch_add(&wrong, 1);
}

/* With 5 threads in all, tasks request 5, 4, 3 and 2 of them. */
static void tasks_of_fewer_threads(void **state) {
    (void)state;
    enum { ROUNDS = 50 };
    int there = 0;
    for (int round = 0; round < ROUNDS; round++) {
        redcc_crew *crew;
#pragma omp parallel num_threads(MOST) private(crew)
        {
#pragma omp single copyprivate(crew)
            {
                there = omp_get_num_threads();
                crew = redcc_crew_new();
            }
            work_of_some(crew);
        }
    }
    assert_int_equal(there, MOST);
    assert_int_equal(atomic_load(&wrong), 0);
    for (int number = 0; number < MOST; number++)
        assert_int_equal(atomic_load(&calls[number]),
                         ROUNDS * (number < 2 ? MOST - 1 : MOST - number));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(tasks_of_fewer_threads)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
