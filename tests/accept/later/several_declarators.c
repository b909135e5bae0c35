/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The bound is declared in the loop's header.
// covers: row 8
#include "../case.h"

enum { N = 12000, M = 700 };
static int s[N];
static double w[N], h[M];

static void several(int n) {
    for (int t = 0, last = n - 1; t <= last; t++) // EXPECT: transformed
        h[s[t]] += w[t];
}

int main(void) {
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        several(N);
        CASE_PRINT(h);
    }
    return 0;
}
