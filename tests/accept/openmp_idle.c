/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A region of one thread, while OpenMP's other threads are idle. No loop has used these threads, but they must not be
// counted as threads of the program. Later a team dismisses them, and they end slowly: the loop must wait for them. The
// same holds after a thread of the program has ended.
// covers: row 55 of docs/constructs.md
// CFLAGS: -fopenmp -pthread
// FLAGS: -fopenmp
// SEQUENTIAL: with OpenMP, the program's own directives may sum in any order
// MAY-RUN-SERIALLY: one loop runs while another thread exists
#define _GNU_SOURCE
#include "case.h"
#include <pthread.h>
#include <time.h>

enum { N = 3000, M = 60, OTHERS = 3, ROUNDS = 10 };
static int s[N];
static double w[N], h[M];
static long counts[M];
static pthread_key_t key;

static void leave_slowly(void *unused) {
    (void)unused;
    nanosleep(&(struct timespec){0, 3000000}, 0);
}

static void come(int threads) {
#pragma omp parallel num_threads(threads)
    pthread_setspecific(key, &key);
}

static pthread_mutex_t until_then = PTHREAD_MUTEX_INITIALIZER;

static void *be_there(void *unused) {
    pthread_mutex_lock(&until_then);
    pthread_mutex_unlock(&until_then);
    return unused;
}

/* while a thread of the program exists; integer sums are the same in any order */
static void count_beside(int n) {
    pthread_t thread;
    pthread_mutex_lock(&until_then);
    if (pthread_create(&thread, 0, be_there, 0))
        abort();
#pragma omp parallel num_threads(2)
    {
#pragma omp for
        for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
            counts[s[t]]++;
        }
    }
    pthread_mutex_unlock(&until_then);
    pthread_join(thread, 0);
}

static void add(int n, int threads) {
#pragma omp parallel num_threads(threads)
    {
#pragma omp for schedule(dynamic, 3)
        for (int t = 0; t < n; t++) { // EXPECT: transformed
#pragma omp atomic
            h[s[t]] += w[t];
        }
    }
}

int main(void) {
    if (pthread_key_create(&key, leave_slowly))
        return 1;
    case_subscripts(s, N, M);
    case_values(w, N);
    come(1 + OTHERS);
    add(N, 1);
    for (int round = 0; round < ROUNDS; round++) {
        come(2 + OTHERS);
        add(N - round, 2);
    }
    count_beside(N);
    add(N, 2);
    for (int round = 0; round < ROUNDS; round++) {
        come(3);
        add(N - round, 2);
    }
    CASE_PRINT(h);
    CASE_PRINT(counts);
    pthread_setspecific(key, 0);
    return 0;
}
