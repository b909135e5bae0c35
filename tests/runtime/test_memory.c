/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Allocations fail from the first call on, then from the second on, and so on until all succeed.
 * The results must be correct each time, and nothing may leak. Also tests the memory limit. Run
 * with a named method. */
#include "base/memory.h"
#include "base/system.h"
#include "loop.h"
#include "problem.h"

#include <errno.h>
#ifdef __linux__
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void fail_everywhere(int number, int threads) {
    struct problem problem = problem_new(number, true);
    const size_t bytes = (size_t)problem.doubles * sizeof(double);
    double *expected = malloc(bytes);
    problem_oracle(&problem);
    memcpy(expected, problem.first, bytes);
    long failures = 0;
    for (bool failed = true; failed; failures++) {
        struct described described;
        long last;
        problem_describe(&problem, &described);
        problem_reset(&problem);
        redcc_memory_fail_after(failures);
        const int parallel = problem_run(&problem, &described, threads, &last);
        failed = redcc_memory_is_exhausted();
        redcc_memory_fail_after(-1);
        assert_memory_equal(expected, problem.first, bytes);
        assert_true(failed || parallel);
        problem_reset(&problem); /* repeats the loop with memory, after the failures */
        assert_true(problem_run(&problem, &described, threads, &last));
        assert_memory_equal(expected, problem.first, bytes);
        redcc_loop_forget(&described.loop);
        assert_int_equal(redcc_memory_live(), 0);
        assert_int_equal(redcc_memory_in_use(), 0);
    }
    assert_true(failures > 20);
    free(expected);
    problem_free(&problem);
}

static void failing_memory(void **unused) {
    (void)unused;
    fail_everywhere(3, 2);
    fail_everywhere(9, 3);
    fail_everywhere(11, 2);
}

/* Data of the report and the learner exist under any limit, but a plan does not. */
static void a_limit_is_kept(void **unused) {
    (void)unused;
    struct problem problem = problem_new(3, true);
    struct described described;
    problem_describe(&problem, &described);
    long last;
    redcc_memory_limit(1);
    redcc_loop_make(&described.loop);
    assert_non_null(described.loop.state);
    const size_t limit = redcc_memory_in_use() + 4000;
    redcc_memory_limit(limit);
    assert_false(problem_run(&problem, &described, 2, &last));
    assert_true(redcc_memory_in_use() <= limit);
    const struct loop_state *state = described.loop.state;
    assert_int_equal(atomic_load(&state->reported.statistics.fallback[REASON_NO_MEMORY]), 1);
    redcc_memory_limit(0);
    assert_true(problem_run(&problem, &described, 2, &last));
    redcc_loop_forget(&described.loop);
    assert_int_equal(redcc_memory_in_use(), 0);
    problem_free(&problem);
}

/* Short loops query the free memory before each execution, and a system call takes longer than many
 * of these loops. If the kernel refuses the query, it must not be repeated. */
static void the_system_is_asked_once(void **unused) {
    (void)unused;
#ifdef __linux__
    const uint64_t there = redcc_system_memory();
    assert_true(there >> 20 > 0);
    struct sock_filter refuse[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_sysinfo, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const struct sock_fprog program = {sizeof refuse / sizeof *refuse, refuse};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
        skip();
    assert_true(redcc_system_memory() == there);
#endif
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(failing_memory), cmocka_unit_test(a_limit_is_kept),
        cmocka_unit_test(the_system_is_asked_once), /* last, since the query stays refused */
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
