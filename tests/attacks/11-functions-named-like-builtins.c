/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions of the program in another file, named like compiler builtins without their prefix
// (parity for __builtin_parity), or like a variant of a library function (absf). Their definitions
// at the file's end stand for definitions in another file.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 20000, BINS = 300 };
int h[BINS];
int calls;
static double sums[BINS];

int parity(int);
int popcount(int);
int clz(int);
double expect(double, double);
double absf(double);
int labsl(int);
double inf(void);
int isinf_sign(double);

static void by_parity(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[s[t]] += parity(t);
}

static void by_popcount(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[s[t]] += popcount(s[t]);
}

static void by_clz(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[s[t]] += clz(t);
}

static void by_expect(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        sums[s[t]] += expect(t, 1.0);
}

static void by_suffix(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        sums[s[t]] += absf(t);
}

static void by_labsl(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[s[t]] += labsl(t);
}

static void by_inf(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        sums[s[t]] += inf();
}

static void by_sign(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[s[t]] += isinf_sign(t);
}

/* library functions, and builtins under their own names */
static void by_library(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        sums[s[t]] += sqrt(t) + fabsf((float)t) + (double)floorl(t) + abs(-t);
}

static void by_builtins(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[s[t]] += __builtin_parity((unsigned)t) + __builtin_popcount((unsigned)t);
}

int main(void) {
    static int k[N];
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL) % BINS);
    for (int round = 0; round < 3; round++) {
        by_parity(N, k);
        by_popcount(N, k);
        by_clz(N, k);
        by_expect(N, k);
        by_suffix(N, k);
        by_labsl(N, k);
        by_inf(N, k);
        by_sign(N, k);
        by_library(N, k);
        by_builtins(N, k);
    }
    double sum = 0;
    long long total = calls;
    for (int i = 0; i < BINS; i++) {
        sum = sum * 0.99 + sums[i];
        total = total * 31 + h[i];
    }
    printf("%a %lld\n", sum, total);
    return 0;
}

/* `weak` and `noinline` keep callers from seeing the definition, as in another file. */
#define ELSEWHERE __attribute__((noinline, weak))
ELSEWHERE int parity(int x) {
    calls++;
    return h[x % BINS] & 1;
}
ELSEWHERE int popcount(int x) {
    return h[x % BINS] & 3;
}
ELSEWHERE int clz(int x) {
    return h[x % BINS] & 7;
}
ELSEWHERE double expect(double x, double y) {
    calls++;
    return sums[(int)x % BINS] * 1e-3 + y;
}
ELSEWHERE double absf(double x) {
    return sums[(int)x % BINS] * 1e-3;
}
ELSEWHERE int labsl(int x) {
    return calls += x & 1;
}
ELSEWHERE double inf(void) {
    return calls++;
}
ELSEWHERE int isinf_sign(double x) {
    return h[(int)x % BINS] & 1;
}
