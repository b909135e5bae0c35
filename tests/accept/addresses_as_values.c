/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The array's values are addresses of its own elements: no method may change them into addresses of a private copy.
// covers: row 41, row 44 of docs/constructs.md
#include "case.h"

enum { N = 6000, M = 300 };
static int s[N];
static long h[M], g[M];

__attribute__((noipa)) static void by_pointer(int n, long *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[s[t]] += ((long)&to[t % M] - (long)h) / 8;
}

__attribute__((noipa)) static void by_name(int n, const long *p) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        g[s[t]] += p == g;
}

int main(void) {
    case_subscripts(s, N, M);
    by_pointer(N, h);
    by_name(N, g);
    CASE_PRINT(h);
    CASE_PRINT(g);
    return 0;
}
