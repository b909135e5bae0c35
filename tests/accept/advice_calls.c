/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops from the section on calls in docs/reasons.md, and changed as it advises (advice_updates.c explains BEFORE).
// CFLAGS: -Wno-unknown-pragmas
// INTEGERS: no
#include <assert.h>
#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <setjmp.h>
#include "case.h"

enum { N = 2000, ROWS = 80 };
static int s[N], calls, fails;
static double e[N], x[N], values[N], h[ROWS], g[ROWS];

static int next(void) { return ++calls; }

/* Counts its calls in `measured`, which its result does not depend on. */
static int measured;
static double measure(int t) {
    measured++;
    return e[t] * 2;
}

static void impure_call(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: impure-call
        h[s[t]] += measure(t);
#else
    for (int t = 0; t < n; t++)
        values[t] = measure(t);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += values[t];
#endif
}

static double half(int t) { return e[t] * 0.5; }

static void function_pointer(int n) {
#ifdef BEFORE
    double (*f)(int) = n ? half : measure;
    for (int t = 0; t < n; t++) // BEFORE: function-pointer
        h[s[t]] += f(t);
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += half(t);
#endif
}

#ifdef BEFORE
static int depth(int k) { return k ? 1 + depth(k / 2) : 0; }
#else
static int depth(int k) {
    int d = 0;
    for (; k; k /= 2)
        d++;
    return d;
}
#endif

static void recursion(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: recursion
        h[s[t]] += depth(t);
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += depth(t);
#endif
}

#ifdef BEFORE
static void add(double *p, int i, double v) { for (; i > 9; i /= 2) if (v > i) return; p[i] += v; }
#else
static void add(double *p, double v) { *p += v; }
static int halved(int i) { while (i > 9) i /= 2; return i; }
static double value(int i, double v) { for (; i > 9; i /= 2) if (v > i) return -0.0; return v; }
#endif

static void callee_updates(int n, double *restrict h) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: callee-updates
        add(h, s[t], e[t]);
    for (int t = 0; t < n; t++) // BEFORE: callee-updates
        add(h, s[t], e[t]);
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        add(&h[halved(s[t])], value(s[t], e[t]));
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[halved(s[t])] += value(s[t], e[t]);
#endif
}

static double find(const double *x, int k) { while (x[k] < 0) k--; return x[k]; }

#ifdef BEFORE
static void callee_reads(int n, const double *x, double *h) {
    for (int t = 0; t < n; t++) // BEFORE: callee-reads
        h[s[t]] += find(x, t);
}
static void callee_reads_again(int n, const double *x, double *h) {
    for (int t = 0; t < n; t++) // BEFORE: callee-reads
        h[s[t]] += find(x, t);
}
#else
static void callee_reads(int n, const double *x, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += find(x, t);
}
static void callee_reads_again(int n, const double *x, double *h) {
#pragma redcc independent
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += find(x, t);
}
#endif

static void no_return(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: no-return
        assert(next() >= 0);
        h[s[t]]++;
    }
#else
    for (int t = 0; t < n; t++)
        assert(next() >= 0);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]]++;
#endif
}

static jmp_buf place;

#ifdef BEFORE
static void jumps_back(int n) {
    int t;
    if (setjmp(place)) return;
    for (t = 0; t < n; t++) // BEFORE: setjmp
        h[s[t]]++;
    longjmp(place, 1);
}
#else
static void all(int n) {
    int t;
    for (t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]]++;
}
static void jumps_back(int n) {
    if (setjmp(place)) return;
    all(n);
    longjmp(place, 1);
}
#endif

static int domain_error(int n, const double *e) {
#ifdef BEFORE
    errno = 0;
    for (int t = 0; t < n; t++) // BEFORE: errno
        h[s[t]] += log(e[t]);
    if (errno) return -1;
#else
    int bad = 0;
    for (int t = 0; t < n; t++)
        bad |= e[t] <= 0;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += log(e[t]);
    if (bad) return -1;
#endif
    return 0;
}

static void thread_state(int n) {
    pthread_t first = pthread_self();
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: thread-state
        h[s[t]] += pthread_self() == first;
#else
    const int is_first = pthread_self() == first;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += is_first;
#endif
}

int main(void) {
    case_subscripts(s, N, ROWS);
    case_values(e, N);
    for (int t = 0; t < N; t++)
        x[t] = t % 7 ? e[t] : 2;
    for (int round = 0; round < 3; round++) {
        impure_call(N);
        function_pointer(N);
        recursion(N);
        callee_updates(N, h);
        callee_reads(N, x, g);
        callee_reads_again(N, x, h);
        no_return(N);
        jumps_back(N);
        thread_state(N);
        for (int t = 0; t < N; t++)
            values[t] = fabs(e[t]) + 1;
        fails += domain_error(N, values);
        if (round == 2) {
            values[7] = -1;
            fails += domain_error(N, values);
        }
    }
    CASE_PRINT(h);
    CASE_PRINT(g);
    printf("%d %d %d\n", measured, calls, fails);
    return 0;
}
