/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Minima and maxima: refused today (min-max).
// covers: row 37
#include "../case.h"

enum { N = 20000, M = 1200 };
static int s[N];
static double v[N], least[M], most[M], chosen[M];

static void extremes(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (v[t] < least[s[t]])
            least[s[t]] = v[t];
        if (most[s[t]] < v[t])
            most[s[t]] = v[t];
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        chosen[s[t]] = chosen[s[t]] > v[t] ? chosen[s[t]] : v[t];
}

int main(void) {
    case_values(v, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        extremes(N);
        CASE_PRINT(least);
        CASE_PRINT(most);
        CASE_PRINT(chosen);
    }
    return 0;
}
