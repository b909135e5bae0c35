/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A function that the loop calls reads x[at[t]] under a condition. If the condition does not hold,
// `at` may not exist: the inspector, which records &x[at[t]], must not read it.
#include <stdio.h>

enum { N = 4000 };
static double h[N], x[N];
static int k[N], at[N];

static double optional(const double *x, const int *at, int t, int is_there) {
    if (is_there)
        return x[at[t]];
    return 1.25;
}

__attribute__((noipa)) static void by_function(int n, double *h, const double *x, const int *k,
                                               const int *at, int is_there) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        h[k[t]] += optional(x, at, t, is_there);
}

static double deeper(const double *x, const int *at, int t, int is_there) {
    return is_there > 1 ? 0.5 * optional(x, at, t, 1) : 1.5;
}

__attribute__((noipa)) static void by_two(int n, double *h, const double *x, const int *k,
                                          const int *at, int is_there) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        h[k[t]] += deeper(x, at, t, is_there);
}

static double certain(const double *x, const int *at, int t, double otherwise) {
    const double v = x[at[t]];
    return v > 0.5 ? v : otherwise;
}

__attribute__((noipa)) static void straight(int n, double *h, const double *x, const int *k,
                                            const int *at) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += certain(x, at, t, 0.25);
}

int main(void) {
    double sum = 0;
    for (int t = 0; t < N; t++) {
        k[t] = (t * 7) % N;
        at[t] = (t * 11) % N;
        x[t] = t % 5 * 0.25;
    }
    for (int round = 0; round < 5; round++) {
        by_function(N, h, x, k, 0, 0);
        by_two(N, h, x, k, 0, round % 2);
        by_function(N, h, x, k, at, 1);
        by_two(N, h, x, k, at, 2);
        straight(N, h, x, k, at);
    }
    for (int t = 0; t < N; t++)
        sum = 0.75 * sum + h[t];
    printf("%.17g\n", sum);
    return 0;
}
