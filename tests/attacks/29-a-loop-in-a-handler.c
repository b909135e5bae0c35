/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* While the program executes a loop, a signal handler executes another loop over other data. */
// THREADS: 2 3 7
#define _GNU_SOURCE
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>

enum { N = 20000, K = 300 };
static int k[N];
static double h[K], expected[K];
static volatile sig_atomic_t handled, wrong, over;

__attribute__((noinline)) static void fill(double *to, int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        to[k[t]] += 1.0 / (1 + t);
}

__attribute__((noinline)) static void fill_other(double *to, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[k[t]] += 2.0;
}

static void again(long microseconds) {
    const struct itimerval after = {{0, 0}, {0, microseconds}};
    setitimer(ITIMER_REAL, &after, NULL);
}

static void note(int number) {
    double own[K] = {0};
    (void)number;
    fill(own, N / 4);
    fill_other(own, N / 4);
    wrong += memcmp(own, expected, sizeof own) != 0;
    handled++;
    if (!over) /* lets the program advance before the next signal */
        again(20 + handled % 64);
}

int main(void) {
    struct sigaction action = {.sa_handler = note};
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    fill(h, N);
    fill_other(h, N);
    fill(expected, N / 4);
    fill_other(expected, N / 4);
    sigaction(SIGALRM, &action, NULL);
    again(100);
    for (int round = 0; round < 1000; round++)
        fill(h, N);
    while (handled < 50)
        ;
    over = 1;
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a %d wrong\n", sum, (int)wrong);
    return 0;
}
