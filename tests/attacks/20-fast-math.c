/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// With -ffast-math the compiler may round each copy of an expression differently. It may also round
// the rest of the file differently, because it inlines other functions there (attack 71). Only files
// without floating-point arithmetic keep their bits (71-integers-by-387.c).
// CFLAGS: -O2 -ffast-math
#include <stdio.h>

enum { N = 20000, BINS = 300 };
static double h[BINS], sum;
static int count[BINS];
static double x[N], y[N];

static void sums(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse inexact-option
        h[s[t]] += x[t] * y[t] / 3.0;
}

static void beside(int n, const int *s) {
    double all = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse inexact-option
        count[s[t]]++;
        all += x[t];
    }
    sum += all;
}

static void subscripts(int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse inexact-option
        count[(int)(x[t] * 0.5 + y[t])]++;
}

static void integers(int n, const int *s) {
    for (int t = 0; t < n; t++) // EXPECT: refuse inexact-option
        count[s[t]] += t;
}

int main(void) {
    static int k[N];
    for (int t = 0; t < N; t++) {
        k[t] = (int)((t * 7919LL) % BINS);
        x[t] = k[t];
        y[t] = 0.25 * k[t];
    }
    for (int round = 0; round < 3; round++) {
        sums(N, k);
        beside(N, k);
        subscripts(N);
        integers(N, k);
    }
    long long total = 0;
    for (int i = 0; i < BINS; i++)
        total = total * 31 + count[i] + (long long)h[i];
    printf("%a %lld\n", sum, total);
    return 0;
}
