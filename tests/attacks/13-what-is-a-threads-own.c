/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// errno, pthread_self() and functions declared const that return an address of the calling thread:
// other threads would get other results.
// OPTIONS: --pure=square
#include <errno.h>
#include <pthread.h>
#include <stdio.h>

enum { N = 20000, BINS = 300 };
static int h[BINS];
static double sums[BINS];
static _Thread_local int own = 3;
static pthread_t first;

__attribute__((const)) int *place(int);
__attribute__((const)) int number(void);
__attribute__((const)) double square(double);
__attribute__((pure)) int read_own(int);

static void by_errno(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-state
        h[s[t]] += errno;
}

static int failed(void) {
    return errno != 0;
}
static void by_callee(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-state
        h[s[t]] += failed();
}

static void by_thread(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-state
        h[s[t]] += pthread_self() == first;
}

static void by_address(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-state
        h[s[t]] += *place(t);
}

static void by_number(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-state
        h[s[t]] += number();
}

static void by_pure(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse unseen-pure
        h[s[t]] += read_own(t);
}

static void of_arguments(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        sums[s[t]] += square(t);
}

int main(void) {
    static int k[N];
    first = pthread_self();
    own = 5;
    for (int t = 0; t < N; t++)
        k[t] = (int)(t * 7919LL % BINS);
    for (int round = 0; round < 3; round++) {
        errno = round + 1;
        by_errno(N, k);
        by_callee(N, k);
        by_thread(N, k);
        by_address(N, k);
        by_number(N, k);
        by_pure(N, k);
        of_arguments(N, k);
    }
    double sum = 0;
    long long total = 0;
    for (int i = 0; i < BINS; i++) {
        sum = sum * 0.99 + sums[i];
        total = total * 31 + h[i];
    }
    printf("%a %lld\n", sum, total);
    return 0;
}

/* keeps callers from seeing the definition, as in another file */
#define ELSEWHERE __attribute__((noinline, weak))
ELSEWHERE int *place(int k) {
    (void)k;
    return &own;
}
ELSEWHERE int number(void) {
    return own;
}
ELSEWHERE double square(double v) {
    return v * v;
}
ELSEWHERE int read_own(int k) {
    return own + k;
}
