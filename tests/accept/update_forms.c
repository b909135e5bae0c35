/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// All spellings of an update.
// covers: row 20, row 21, row 39, row 27 of docs/constructs.md
// COMPILERS: gcc clang-19
// CFLAGS: -march=native
#include "case.h"

enum { N = 20000, M = 1500 };
static int s[N];
static double w[N], plus[M], equal[M], reversed[M], minus[M], down[M];
static int count[M], back[M];
static unsigned char bytes[M];
static short shorts[M];
static unsigned long long wide[M];
static float single[M];

static void forms(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        plus[s[t]] += w[t];
        equal[s[t]] = equal[s[t]] + w[t];
        reversed[s[t]] = w[t] * 3.0 + reversed[s[t]];
        minus[s[t]] -= w[t];
        down[s[t]] = down[s[t]] - w[t] * w[t];
    }
}

static void counters(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        count[s[t]]++;
        --back[s[t]];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        ++bytes[s[t]];
        shorts[s[t]] += 7;
        wide[s[t]] += (unsigned long long)t << 40;
    }
}

static void narrow(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        single[s[t]] += (float)w[t];
}

int main(void) {
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        forms(N);
        counters(N - round);
        narrow(N);
        CASE_PRINT(plus);
        CASE_PRINT(equal);
        CASE_PRINT(reversed);
        CASE_PRINT(minus);
        CASE_PRINT(down);
        CASE_PRINT(count);
        CASE_PRINT(back);
        CASE_PRINT(bytes);
        CASE_PRINT(shorts);
        CASE_PRINT(wide);
        CASE_PRINT(single);
    }
    return 0;
}
