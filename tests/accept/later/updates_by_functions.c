/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The update stands in a function that gets the element's address.
// covers: row 18
#include "../case.h"

enum { N = 12000, M = 800 };
static int edge[N][2];
static double x[M][3], h[M];

static inline void add(double *target, double value) {
    *target += value;
}

static void through_pointer(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        add(&h[edge[t][0]], x[edge[t][1]][0]);
        add(&h[edge[t][1]], x[edge[t][0]][1]);
    }
}

int main(void) {
    case_values(&x[0][0], 3 * M);
    for (int round = 0; round < 3; round++) {
        case_subscripts(&edge[0][0], 2 * N, M);
        through_pointer(N);
        CASE_PRINT(h);
    }
    return 0;
}
