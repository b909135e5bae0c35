/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A child process made by _Fork (POSIX 2024) or by clone, which do not call the handlers of pthread_atfork. */
// METHODS: localwrite auto
#define _GNU_SOURCE
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

enum { N = 60000, K = 700 };
static int k[N];
static double h[K];

__attribute__((noinline)) static double fill(void) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += 1.0 / (1 + t);
    return h[k[N / 2]];
}

static void child(const char *what) {
    printf("%s: %a\n", what, fill() + fill());
    fflush(stdout);
    _exit(0);
}

int main(void) {
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    printf("%a\n", fill());
    fflush(stdout);
    pid_t made = fork();
    if (made == 0)
        child("fork");
    waitpid(made, NULL, 0);
#if __GLIBC_PREREQ(2, 34)
    made = _Fork();
    if (made == 0)
        child("_Fork");
    waitpid(made, NULL, 0);
#endif
    made = (pid_t)syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0);
    if (made == 0)
        child("clone");
    waitpid(made, NULL, 0);
    printf("%a\n", fill());
    return 0;
}
