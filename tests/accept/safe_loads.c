/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The subscript is loaded under a condition on computed values, but the load is safe without the
// condition: the same element was loaded before, or the counter alone gives its place.
// covers: row 35 of docs/constructs.md
#include "case.h"

enum { N = 12000, M = 700 };
static int s[N][2];
static double x[M], h[M];

static void decided(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double d = x[s[t][0]] - 0.25 * x[s[t][1]];
        if (d > 0.0)
            h[s[t][0]] += d;
    }
}

int main(void) {
    case_values(x, M);
    for (int round = 0; round < 3; round++) {
        case_subscripts(&s[0][0], 2 * N, M);
        decided(N);
        CASE_PRINT(h);
    }
    return 0;
}
