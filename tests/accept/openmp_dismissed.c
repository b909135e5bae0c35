/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Threads of a larger team that a smaller one dismisses end slowly. They execute none of the program's loops, so that
// the loop is in the sequential order even so.
// covers: row 55
// CFLAGS: -fopenmp -pthread
// FLAGS: -fopenmp
// SEQUENTIAL: its directives add up in any order
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
        if (round % 2 == 0) /* dismissed before any loop knows of them */
            come(2);
        add(N - round);
        CASE_PRINT(h);
    }
    pthread_setspecific(key, 0);
    return 0;
}
