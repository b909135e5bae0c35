/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Minima and maxima of integers commute: methods with private copies are possible as well.
// covers: row 37, row 38, row 39 of docs/constructs.md
#include "case.h"

enum { N = 20000, M = 900 };
static int s[N];
static int v[N], least[M], most[M];
static unsigned char b[N], high[M];
static long long w[N], wide[M];

static void extremes(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (v[t] < least[s[t]])
            least[s[t]] = v[t];
        most[s[t]] = most[s[t]] >= v[t] ? most[s[t]] : v[t];
        if (high[s[t]] <= b[t]) {
            high[s[t]] = b[t];
        }
        wide[s[t]] = w[t] > wide[s[t]] ? wide[s[t]] : w[t];
    }
}

int main(void) {
    for (int i = 0; i < N; i++) {
        v[i] = (int)case_random();
        b[i] = (unsigned char)case_below(256);
        w[i] = (long long)case_random();
    }
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        extremes(N - round);
        CASE_PRINT(least);
        CASE_PRINT(most);
        CASE_PRINT(high);
        CASE_PRINT(wide);
    }
    return 0;
}
