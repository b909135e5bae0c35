/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Pragmas state that an array is private where the proof fails, that functions have no side
// effects, and that pointers do not overlap.
// covers: row 17, row 29, row 54, row 56, row 59 of docs/constructs.md
// CFLAGS: -Wno-unknown-pragmas
#include "case.h"

enum { N = 20000, M = 1200, PARTS = 8 };
static int s[N], parts[N];
static double v[N], h[M], g[M];

static void with_parts(int n, const int *restrict part_count) {
    double f[PARTS];
#pragma redcc private(f)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int count = part_count[t];
        for (int i = 0; i < count; i++)
            f[i] = v[t] * i;
        for (int i = 0; i < count; i++)
            h[s[t]] += f[i];
    }
}

static volatile double factor = 0.5; /* unchanged while the loop runs */
static double scaled(double x) {
    return factor * x;
}
#pragma redcc pure(scaled)

static void with_calls(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        g[s[t]] += scaled(v[t]);
}

static void apart(int n, const int *k, const double *w, double *a) {
#pragma redcc independent
#pragma GCC unroll 2
    for (int t = 0; t < n; t++) // EXPECT: transformed
        a[k[t]] += w[t];
}

int main(void) {
    case_values(v, N);
    for (int t = 0; t < N; t++)
        parts[t] = t % (PARTS + 1);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        with_parts(N, parts);
        with_calls(N);
        apart(N, s, v, g);
        CASE_PRINT(h);
        CASE_PRINT(g);
    }
    return 0;
}
