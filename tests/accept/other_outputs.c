/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Outputs in addition to the updates: a separate element per iteration, and a sum.
// covers: row 59 of docs/constructs.md
#include "case.h"

enum { N = 20000, M = 1200 };
static int s[N];
static double v[N], h[M], out[N], total;

static void both(int n) {
    double sum = 0.0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        out[t] = v[t] * v[t];
        h[s[t]] += out[t];
        sum += v[t];
    }
    total = sum;
}

int main(void) {
    case_values(v, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        both(N);
        CASE_PRINT(h);
        CASE_PRINT(out);
        case_print("total", &total, sizeof total);
    }
    return 0;
}
