/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A declaration before the definition sets compiler options for the function by an attribute. The loop's
// body must not move to another function, which would round differently.
#include <stdio.h>

enum { N = 40000, K = 64 };
static double h[K], v[N];
static int k[N];

#define RELAXED __attribute__((__optimize__("fast-math")))
__attribute__((optimize("fast-math"))) void said_before(int n, const int *restrict s, const double *restrict w,
                                                        double *restrict b);
RELAXED void by_macro(int n, const int *restrict s, const double *restrict w, double *restrict b);

void said_before(int n, const int *restrict s, const double *restrict w, double *restrict b) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        const double x = w[t] / 3.0 + w[t] / 7.0, y = x + 1e16 - 1e16;
        b[s[t]] += y + x * x * x * x * x;
    }
}

void by_macro(int n, const int *restrict s, const double *restrict w, double *restrict b) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        const double x = w[t] / 3.0 + w[t] / 11.0, y = x + 1e16 - 1e16;
        b[s[t]] += y + x * x * x * x * x;
    }
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = t * 7919 % K;
        v[t] = 1.0 / (1 + t);
    }
    for (int round = 0; round < 4; round++) {
        said_before(N, k, v, h);
        by_macro(N, k, v, h);
    }
    for (int i = 0; i < K; i++)
        printf("%a\n", h[i]);
    return 0;
}
