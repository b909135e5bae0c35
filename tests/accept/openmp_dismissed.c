/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Threads that leave when a smaller team follows a larger one take long to end. They execute no iterations, so the
// loop still gets the same bits.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp -pthread
// FLAGS: -fopenmp
// FIXED: 31
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
#define _GNU_SOURCE
#include "case.h"
#include <pthread.h>
#include <time.h>

enum { N = 20000, M = 300, MORE = 20 };
static int s[N];
static double w[N], h[M];
static pthread_key_t key;

static void leave_slowly(void *unused) {
    (void)unused;
    nanosleep(&(struct timespec){0, 30000000}, 0);
}

static void come(int threads) {
#pragma omp parallel num_threads(threads)
    pthread_setspecific(key, &key);
}

static void add(int n) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
        h[s[t]] += w[t];
    }
}

int main(void) {
    if (pthread_key_create(&key, leave_slowly))
        return 1;
    case_subscripts(s, N, M);
    case_values(w, N);
    for (int round = 0; round < 4; round++) {
        come(MORE);
        if (round % 2 == 0) /* dismissed before any loop has counted these threads */
            come(2);
        add(N - round);
        CASE_PRINT(h);
    }
    pthread_setspecific(key, 0);
    return 0;
}
