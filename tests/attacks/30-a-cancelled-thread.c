/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A thread that only computes and may be cancelled at any time (POSIX). */
// THREADS: 2 3
// METHODS: localwrite auto
// LINK: -pthread
#define _GNU_SOURCE
#include <pthread.h>
#include <stdio.h>
#include <unistd.h>

enum { N = 60000, K = 700 };
static int k[N];
static double h[K], own[K];

__attribute__((noinline)) static void fill(double *to) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        to[k[t]] += 1.0 / (1 + t);
}

static void *compute(void *unused) {
    int before;
    pthread_setcanceltype(PTHREAD_CANCEL_ASYNCHRONOUS, &before);
    for (;;)
        fill(own);
    return unused;
}

int main(void) {
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    int cancelled = 0;
    for (int round = 0; round < 30; round++) {
        pthread_t thread;
        void *result;
        pthread_create(&thread, NULL, compute, NULL);
        usleep(3000 + 177 * (unsigned)round);
        pthread_cancel(thread);
        pthread_join(thread, &result);
        cancelled += result == PTHREAD_CANCELED;
        fill(h);
    }
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a %d\n", sum, cancelled);
    return 0;
}
