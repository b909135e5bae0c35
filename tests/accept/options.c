/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Options state that a function has no side effects and that pointers do not overlap.
// covers: row 17 of docs/constructs.md
// OPTIONS: --pure=weight --assume-noalias
#include "case.h"

enum { N = 9000, M = 700 };

double weight(int i);

static void scatter(double *h, const double *x, const int *s, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += x[s[t]] * weight(t);
}

int main(void) {
    static double h[M], x[M];
    static int s[N];
    case_values(x, M);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        scatter(h, x, s, N);
        CASE_PRINT(h);
    }
    return 0;
}

__attribute__((noinline)) double weight(int i) {
    static const double table[4] = {1.0, 0.5, 0.25, 2.0};
    return table[i % 4];
}
