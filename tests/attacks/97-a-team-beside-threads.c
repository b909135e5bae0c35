/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fopenmp
// THREADS: 1 2 7
// METHODS: auto localwrite binning
// A team executes a loop while other threads update the same elements: a thread of the program, that thread's
// team, other teams of an enclosing region, and tasks that run at the team's barrier.
#include <omp.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>

enum { N = 20000, M = 5, ROUNDS = 20, MANY = 80 };
static int s[N];
static long h[M], others;
static atomic_int begun;

static void update(int n) {
#pragma omp for nowait
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        h[s[t]] += t & 3;
    }
}

static void by_team(int threads) {
#pragma omp parallel num_threads(threads)
    {
#pragma omp single nowait
        for (int i = 0; i < M; i++) {
#pragma omp task
            {
#pragma omp atomic
                h[i] += 1;
            }
        }
        update(N);
        update(N / 2);
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
        by_team(2);
    return unused;
}

static void with(void *(*other)(void *)) {
    pthread_t thread;
    atomic_store(&begun, 0);
    pthread_create(&thread, NULL, other, NULL);
    while (!atomic_load(&begun))
        ;
    for (int round = 0; round < ROUNDS; round++)
        by_team(3);
    atomic_store(&begun, 2);
    pthread_join(thread, NULL);
}

int main(void) {
    for (int t = 0; t < N; t++)
        s[t] = t * 7919 % M;
    omp_set_max_active_levels(2);
    for (int round = 0; round < 3; round++)
        by_team(omp_get_max_threads());
    with(beside);
    with(the_same);
#pragma omp parallel num_threads(3)
    for (int round = 0; round < MANY; round++)
        by_team(2);
    by_team(2);
    long all = -others;
    for (int i = 0; i < M; i++)
        all += h[i];
    printf("%ld\n", all);
    return 0;
}
