/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Bounds that are floating-point literals with whole values: `#define N 1e4`.
// covers: row 8, row 9 of docs/constructs.md
#include <stddef.h>

#include "case.h"

#define N 1e4
#define POINTS 6e2
#define M 900
static int s[(int)N];
static double w[(int)N], h[M], x[(int)POINTS], f[(int)POINTS];
static long seen[8];

static void headers(int from) {
    int t;
    for (t = from; t < N; t++) // EXPECT: transformed
        h[s[t]] += w[t];
    seen[0] = t;
    for (t = from; t <= 9e3; t += 3) // EXPECT: transformed
        h[s[t]] -= w[t];
    seen[1] = t;
    for (t = 9999; 2.f < t; t--) // EXPECT: transformed
        h[s[t]] += w[t] * 0.5;
    seen[2] = t;
    for (t = 0; t != 0x1p13; ++t) // EXPECT: transformed
        h[s[t]] -= w[t] * 0.25;
    seen[3] = t;
    t = 1;
    while (t < 7777.) { // EXPECT: transformed
        h[s[t]] += w[t] * 0.125;
        t++;
    }
    seen[4] = t;
    for (t = from; t < -1 || t > 1e5; t++)
        seen[5]++;
}

static void types(void) {
    for (size_t t = 0; t < N; t++) // EXPECT: transformed
        h[s[t]] += w[t];
    for (unsigned t = 3; t < 5e3f; t++) // EXPECT: transformed
        h[s[t]] += w[t - 1];
    for (long long t = 0; t < 9007199254740991.0 && t < 1; t++)
        seen[6]++;
}

/* All pairs, and a condition that compares the counter with a floating-point literal. */
static void pairs(double cut) {
    for (int i = 0; i < POINTS; i++) // EXPECT: transformed
        for (int j = i + 1; j < POINTS; j++) {
            const double d = x[i] - x[j];
            if (d * d < cut && j < 5.5e2) {
                f[i] += d / (0.1 + d * d);
                f[j] -= d / (0.1 + d * d);
            }
        }
}

int main(void) {
    case_values(w, (long)N);
    case_values(x, (long)POINTS);
    case_subscripts(s, (long)N, M);
    for (int round = 0; round < 3; round++) {
        headers(round - 2 < 0 ? 0 : 5000);
        headers(9998);
        types();
        pairs(0.25);
    }
    CASE_PRINT(h);
    CASE_PRINT(f);
    CASE_PRINT(seen);
    return 0;
}
