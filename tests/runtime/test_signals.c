/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Which signals are blocked during a loop, and in which threads. Also: a loop's threads have the
 * memory rights of the thread that entered it. */
#define _GNU_SOURCE
#include "base/rights.h"
#include "base/signals.h"
#include "base/team.h"
#include "base/within.h"
#include "problem.h"

#include <omp.h>
#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <ucontext.h>

#include <cmocka.h>

static void nothing(int number) {
    (void)number;
}

static bool waits(int number) {
    sigset_t now;
    pthread_sigmask(SIG_BLOCK, NULL, &now);
    return sigismember(&now, number) == 1;
}

static void *take_over(void *before) {
    *(bool *)before = waits(SIGTERM) || waits(SIGINT) || waits(SIGALRM);
    redcc_signals_take_over();
    return waits(SIGTERM) && waits(SIGINT) && waits(SIGALRM) && waits(SIGUSR1) ? before : NULL;
}

/* While threads are created, handled signals are blocked, but not SIGTERM, SIGINT, SIGALRM and
 * SIGSEGV without handlers. */
static void while_threads_are_made(void **unused) {
    (void)unused;
    struct within within;
    pthread_t thread;
    bool waited = true;
    void *result = NULL;
    signal(SIGUSR1, nothing);
    redcc_within_begin(&within, false, 64);
    assert_true(waits(SIGTERM)); /* since a sequential loop may follow at once */
    assert_int_equal(redcc_team_prepare(2, within.signals), 2);
    assert_false(waits(SIGTERM) || waits(SIGINT) || waits(SIGALRM) || waits(SIGSEGV));
    assert_true(waits(SIGUSR1) && waits(SIGRTMIN));
    assert_int_equal(pthread_create(&thread, NULL, take_over, &waited), 0);
    assert_int_equal(pthread_join(thread, &result), 0);
    /* In this thread all signals are blocked while it executes its part of the region. */
    assert_ptr_equal(result, &waited);
    assert_false(waited);
    redcc_within_end(within);
    assert_false(waits(SIGUSR1) || waits(SIGTERM));
    assert_int_equal(pthread_create(&thread, NULL, take_over, &waited), 0);
    assert_int_equal(pthread_join(thread, &result), 0);
    assert_null(result); /* a thread of the program is left unchanged */
    signal(SIGUSR1, SIG_DFL);
}

/* ---- protection keys ------------------------------------------------------------------------- */

#if defined(__x86_64__)

/* On a processor without protection keys this handler executes the two instructions. */
static _Thread_local uint32_t rights;
static atomic_int reads, writes;

static void execute(int number, siginfo_t *info, void *context) {
    (void)number;
    (void)info;
    greg_t *const registers = ((ucontext_t *)context)->uc_mcontext.gregs;
    const unsigned char *const code = (const unsigned char *)registers[REG_RIP];
    if (code[0] != 0x0f || code[1] != 0x01 || (code[2] != 0xee && code[2] != 0xef))
        abort();
    if (code[2] == 0xee) {
        registers[REG_RAX] = rights;
        registers[REG_RDX] = 0;
        atomic_fetch_add(&reads, 1);
    } else {
        rights = (uint32_t)registers[REG_RAX];
        atomic_fetch_add(&writes, 1);
    }
    registers[REG_RIP] += 3;
}

static void rights_of_threads(void **unused) {
    (void)unused;
    const struct sigaction executes = {.sa_sigaction = execute, .sa_flags = SA_SIGINFO};
    struct sigaction before;
    if (redcc_rights() != 0)
        skip(); /* this processor has protection keys, with which attacks.77 tests the rights */
    sigaction(SIGILL, &executes, &before);
    redcc_rights_assumed = true;
    rights = 0x5c;
    assert_int_equal(redcc_rights(), 0x5c);
    redcc_rights_set(0x5c);
    assert_int_equal(atomic_load(&writes), 0);
    redcc_rights_set(0x30);
    assert_int_equal(rights, 0x30);
    for (int threads = 1; threads <= 7; threads += 2) { /* the others borrow the rights */
        struct problem problem = problem_new(0, true);
        struct described described;
        long last = 0;
        problem_describe(&problem, &described);
        problem_reset(&problem);
        atomic_store(&writes, 0);
        const int done = problem_run(&problem, &described, threads, &last);
        assert_true(done || threads == 1);
        assert_int_equal(atomic_load(&writes), done ? 2 * (threads - 1) : 0);
        problem_free(&problem);
    }
    redcc_rights_assumed = false;
    sigaction(SIGILL, &before, NULL);
}
#else
static void rights_of_threads(void **unused) {
    (void)unused;
}
#endif

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(while_threads_are_made),
                                       cmocka_unit_test(rights_of_threads)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
