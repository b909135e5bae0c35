/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// lrint and similar functions use the current rounding mode: a plan made under another mode must
// not be reused.
#include <fenv.h>
#include <math.h>
#include <stdio.h>

enum { N = 30000, BINS = 4000 };
static int h[BINS];
static double x[N];

static void nearest(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[lrint(x[t])]++;
}

static void integral(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[(int)rint(x[t])] += 3;
}

static void nearby(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[(int)nearbyint(x[t])] += 5;
}

static void plain(int n, const int *k) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += 7;
}

int main(void) {
    static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    static int k[N];
    for (int t = 0; t < N; t++) {
        x[t] = (t * 7919LL % 39990) / 10.0;
        k[t] = (int)x[t];
    }
    for (int round = 0; round < 12; round++) {
        fesetround(modes[round * 3 / 2 % 4]);
        nearest(N);
        integral(N);
        nearby(N);
        plain(N, k);
        unsigned long long hash = 0;
        for (int i = 0; i < BINS; i++)
            hash = hash * 1000003 + (unsigned)h[i];
        printf("%d %llu\n", round, hash);
    }
    return 0;
}
