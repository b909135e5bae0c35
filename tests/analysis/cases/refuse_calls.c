/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reasons R4xx. Covers rows 14 to 19, 57 and 62 of docs/constructs.md. Functions declared pure:
// PURE: trusted
 */
#include <assert.h>
#include <errno.h>
#include <math.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern double unknown(double);
extern double trusted(double);
extern double attribute_const(double) __attribute__((const));
extern double attribute_pure(const double *) __attribute__((pure));

void impure(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse impure-call
        h[s[i]] += unknown(1.0);
    for (int i = 0; i < n; i++) // EXPECT: refuse impure-call
        h[s[i]] += rand();
    for (int i = 0; i < n; i++) { // EXPECT: refuse impure-call
        printf("%d\n", i);
        h[s[i]] += 1.0;
    }
    for (int i = 0; i < n; i++) // EXPECT: transform h(+)
        h[s[i]] += trusted(1.0);
    for (int i = 0; i < n; i++) // EXPECT: refuse unseen-pure
        h[s[i]] += attribute_const(1.0);
}

static double counted(double x) {
    static int calls;
    calls++;
    return x;
}

void static_local(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse impure-call
        h[s[i]] += counted(1.0);
}

void pointer(int n, const int *s, double *h, double (*f)(double)) {
    for (int i = 0; i < n; i++) // EXPECT: refuse function-pointer
        h[s[i]] += f(1.0);
}

static int factorial(int k) {
    return k < 2 ? 1 : k * factorial(k - 1);
}

void recursive(int n, const int *s, int *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse recursion
        h[s[i]] += factorial(3);
}

static void add(double *d, double v) {
    d[1] += v;
}

void callee_updates(int n, const int *s, double *h, double *g) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse callee-updates
        add(&g[s[i]], 1.0);
        h[s[i]] += 1.0;
    }
}

static double first(const double *x) {
    return x[0];
}

static double walk(const double *x, int k) {
    while (k > 0)
        k -= (int)x[k];
    return x[k];
}

double global_table[100];

static double by_global(int i) {
    return global_table[i];
}

void callee_reads(int n, const int *s, double *h, const double *x) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[s[i]] += first(h);
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[s[i]] += walk(x, i);
    for (int i = 0; i < n; i++) // EXPECT: refuse unseen-pure
        h[s[i]] += attribute_pure(x);
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[s[i]] += (double)strlen((const char *)x);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += first(x);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += by_global(i);
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        global_table[s[i]] += by_global(i);
}

void no_return(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse no-return
        while (s[i] < 0)
            abort();
        h[s[i]] += 1.0;
    }
}

jmp_buf place;

void jumps(int n, const int *s, double *h) {
    if (setjmp(place))
        return;
    for (int i = 0; i < n; i++) // EXPECT: refuse setjmp
        h[s[i]] += 1.0;
}

int reads_errno(int n, const int *s, double *h) {
    errno = 0;
    for (int i = 0; i < n; i++) // EXPECT: refuse errno
        h[s[i]] += log((double)i);
    return errno;
}
