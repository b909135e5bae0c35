/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Subscripts that the iteration itself stores before it uses them, as in IS of the NAS Parallel Benchmarks.
// covers: row 31 of docs/constructs.md
#include "case.h"

enum { N = 20000, M = 1200 };
static int key[N], copy[N], h[M];

static void count(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        copy[t] = key[t];
        h[copy[t]]++;
    }
}

int main(void) {
    for (int round = 0; round < 3; round++) {
        case_subscripts(key, N, M);
        count(N);
        CASE_PRINT(h);
        CASE_PRINT(copy);
    }
    return 0;
}
