/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A switch precedes an update under a floating-point condition: its break statements do not prevent the analysis.
// covers: row 6 of docs/constructs.md
#include "case.h"

enum { N = 12000, M = 700 };
static int s[N][2];
static double x[M], h[M];

static void decided(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = s[t][0];
        double sum = x[i];
        switch (i % 3) {
        case 0:
            sum *= 2.0;
            break;
        default:
            sum += 0.5;
        }
        h[i] += sum;
        if (sum > 0.0)
            h[s[t][1]] += x[i];
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
