/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Minima and maxima in all spellings, with NaN and zeros of both signs among the values. The program's own
// comparison decides which of two zeros, or of a NaN and a number, remains.
// covers: row 37, row 2 of docs/constructs.md
#include <math.h>

#include "case.h"

#define MAX(a, b) ((a) > (b) ? (a) : (b))
#define LOWER(place, v)                                                                            \
    do {                                                                                           \
        if ((v) < (place))                                                                         \
            (place) = (v);                                                                         \
    } while (0)

enum { N = 20000, M = 1200 };
static int s[N];
static double v[N], least[M], most[M], chosen[M], other[M];
static float f[N], low[M];

static void conditional(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (v[t] < least[s[t]])
            least[s[t]] = v[t];
        if (most[s[t]] < v[t])
            most[s[t]] = v[t];
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (!(least[s[t]] <= v[t])) {
            least[s[t]] = v[t];
        }
}

static void selected(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        chosen[s[t]] = chosen[s[t]] > v[t] ? chosen[s[t]] : v[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        other[s[t]] = MAX(other[s[t]], v[t]);
}

static void by_function(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        chosen[s[t]] = fmax(chosen[s[t]], v[t]);
        low[s[t]] = fminf(f[t], low[s[t]]);
    }
}

static void by_macro(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        LOWER(other[s[t]], v[t]);
}

static void clamped(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (most[s[t]] > 0.75)
            most[s[t]] = -0.5;
        else if (most[s[t]] < -0.75)
            most[s[t]] *= -0.5;
        else
            most[s[t]] += 0.125 * v[t];
}

int main(void) {
    case_values(v, N);
    for (int i = 0; i < N; i++) {
        if (case_below(50) == 0)
            v[i] = NAN;
        else if (case_below(20) == 0)
            v[i] = case_below(2) ? 0.0 : -0.0;
        f[i] = (float)v[i];
    }
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        conditional(N);
        selected(N);
        by_function(N);
        by_macro(N);
        CASE_PRINT(least);
        CASE_PRINT(most);
        clamped(N);
        CASE_PRINT(most);
        CASE_PRINT(chosen);
        CASE_PRINT(other);
        CASE_PRINT(low);
    }
    return 0;
}
