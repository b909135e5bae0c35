/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A signal handler that interrupted malloc executes the program's first parallel loop. OpenMP would
 * allocate memory for its threads there. */
// THREADS: 2 3 7
// METHODS: localwrite auto
// SECONDS: 20
#define _GNU_SOURCE
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

enum { N = 20000, K = 300 };
static int k[N];
static double h[K], expected[K];
static volatile sig_atomic_t handled, wrong, kept;

__attribute__((noinline)) static void fill(double *to, int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        to[k[t]] += 1.0 / (1 + t);
}

static void again(long microseconds) {
    const struct itimerval after = {{0, 0}, {0, microseconds}};
    setitimer(ITIMER_REAL, &after, NULL);
}

static void note(int number) {
    double own[K] = {0};
    (void)number;
    fill(own, N);
    if (kept)
        wrong += memcmp(own, expected, sizeof own) != 0;
    memcpy(expected, own, sizeof own);
    kept = 1;
    if (++handled < 5) /* lets the program advance before the next signal */
        again(100);
}

static int once(long delay) {
    signal(SIGALRM, note);
    again(delay);
    void *block[64] = {0};
    for (int i = 0; handled < 5; i = (i + 1) % 64) {
        free(block[i]);
        block[i] = malloc((size_t)(2000 + 100 * i));
    }
    return wrong;
}

int main(void) {
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    for (int round = 0; round < 40; round++) {
        const pid_t child = fork();
        if (child == 0)
            _exit(once(200 + round));
        int status;
        waitpid(child, &status, 0);
        if (status)
            printf("wrong\n");
    }
    fill(h, N);
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a\n", sum);
    return 0;
}
