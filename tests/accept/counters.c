/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loop headers: directions, steps, comparisons, types, counters used after the loop, loops without iterations.
// covers: row 8, row 9, row 11, row 53, row 7 of docs/constructs.md
#include "case.h"
#include <stddef.h>

enum { N = 12000, M = 900 };
static int s[N];
static double w[N], h[M];
static long seen[16];

static void headers(int n) {
    int t;
    short u;
    for (t = n - 1; t >= 0; t--) // EXPECT: transformed
        h[s[t]] += w[t];
    seen[0] = t;
    for (t = 0; t <= n - 1; t++) // EXPECT: transformed
        h[s[t]] += w[t] * 0.5;
    seen[1] = t;
    for (t = 0; t < n; t += 3) // EXPECT: transformed
        h[s[t]] += w[t] * 0.25;
    seen[2] = t;
    for (t = n; t > 4; t -= 4) // EXPECT: transformed
        h[s[t - 1]] += w[t - 1];
    seen[3] = t;
    if (n >= 0)
        for (t = 0; t != n; ++t) // EXPECT: transformed
            h[s[t]] -= w[t];
    seen[4] = t;
    for (u = 0; u < n; u++) // EXPECT: refuse counter-wraps
        h[s[u]] += w[u] * 0.125;
    seen[5] = u;
    for (t = 0; n > t; t = t + 1) // EXPECT: transformed
        h[s[t]] += w[t];
    seen[6] = t;
}

static void types(size_t n, const double *v) {
    for (size_t t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += v[t];
    for (unsigned t = 1; t < (unsigned)n; t++) // EXPECT: transformed
        h[s[t]] += v[t - 1];
    for (long long t = 5; t < (long long)n - 5; t++) // EXPECT: transformed
        h[s[t + 5]] += v[t - 5];
    for (ptrdiff_t t = 0; t < (ptrdiff_t)n; ++t) // EXPECT: transformed
        h[s[t]] += v[t];
}

static void as_while(int n) {
    int t = 0;
    while (t < n) { // EXPECT: transformed
        h[s[t]] += w[t];
        t++;
    }
    seen[7] = t;
}

int main(void) {
    static const int trips[] = {N, 0, 1, 2, -5, 5000, N};
    case_values(w, N);
    for (int round = 0; round < 7; round++) {
        case_subscripts(s, N, M);
        headers(trips[round]);
        types(trips[round] > 0 ? (size_t)trips[round] : 0, w);
        as_while(trips[round]);
        CASE_PRINT(h);
        CASE_PRINT(seen);
    }
    return 0;
}
