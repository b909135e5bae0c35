/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fopenmp
// THREADS: 1 2 7
// METHODS: auto localwrite binning
// Threads outside the region update the same elements, and the directives protect all of them.
// Without the directives updates would be lost.
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>

enum { N = 20000, M = 5, ROUNDS = 30 };
static int s[N];
static long h[M], others;
static atomic_int begun;

static void update(int n) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        h[s[t]] += t & 3;
    }
}

static void update_by_critical(int n) {
#pragma omp parallel for num_threads(2)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp critical
        h[s[t]] += 1;
    }
}

static void *beside(void *unused) {
    atomic_store(&begun, 1);
    while (atomic_load(&begun) == 1) {
        for (int i = 0; i < M; i++) {
#pragma omp atomic
            h[i] += 1;
        }
        others += M;
    }
    return unused;
}

static void *the_same(void *unused) {
    atomic_store(&begun, 1);
    for (int round = 0; round < ROUNDS; round++)
        update(N);
    return unused;
}

static void with(void *(*other)(void *)) {
    pthread_t thread;
    atomic_store(&begun, 0);
    pthread_create(&thread, NULL, other, NULL);
    while (!atomic_load(&begun))
        ;
    for (int round = 0; round < ROUNDS; round++)
        update(N);
    atomic_store(&begun, 2);
    pthread_join(thread, NULL);
    update_by_critical(N); /* `critical` and `atomic` do not exclude each other */
}

int main(void) {
    for (int t = 0; t < N; t++)
        s[t] = t * 7919 % M;
    for (int round = 0; round < 3; round++)
        update(N);
    with(beside);
    with(the_same);
#pragma omp parallel num_threads(3)
    {
#pragma omp for
        for (int round = 0; round < 6; round++)
            update(N);
    }
    for (int round = 0; round < 3; round++)
        update(N);
    long all = -others;
    for (int i = 0; i < M; i++)
        all += h[i];
    printf("%ld\n", all);
    return 0;
}
