/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A signal handler leaves the computation by siglongjmp (POSIX). The program then clears the array that it left, and
 * later loops run as usual. The output does not depend on how far the first loop got. */
// THREADS: 2 3 7
// METHODS: localwrite auto
// SECONDS: 60
#define _GNU_SOURCE
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>

enum { N = 200000, K = 3000 };
static int k[N];
static double h[K];
static sigjmp_buf out;

static void end(int number) {
    (void)number;
    siglongjmp(out, 1);
}

__attribute__((noinline)) static void fill(double weight) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += weight / (1 + t);
}

__attribute__((noinline)) static void limited(long microseconds) {
    const struct itimerval at = {{0, 0}, {0, microseconds}}, none = {{0, 0}, {0, 0}};
    if (sigsetjmp(out, 1) == 0) {
        setitimer(ITIMER_REAL, &at, NULL);
        for (;;)
            fill(1.0);
    }
    setitimer(ITIMER_REAL, &none, NULL);
}

int main(void) {
    signal(SIGALRM, end);
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    for (int round = 0; round < 40; round++) {
        limited(5000 + 377 * round);
        memset(h, 0, sizeof h);
        for (int wait = 0; wait < 100000; wait++)
            for (int i = 0; i < 3; i++)
                if (((volatile double *)h)[i] != 0) {
                    printf("somebody still writes\n");
                    return 1;
                }
    }
    fill(2.0);
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a\n", sum);
    return 0;
}
