/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops called from several threads at once, and from inside a parallel region.
// covers: row 55, row 72 of docs/constructs.md
// CFLAGS: -fopenmp
// MAY-RUN-SERIALLY: inside a parallel region loops are sequential
#include "case.h"

enum { N = 6000, M = 500, CALLERS = 4 };
static int s[CALLERS][N];
static double w[N], h[CALLERS][M];

static void scatter(double *to, const int *at, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += w[t];
}

int main(void) {
    case_values(w, N);
    case_subscripts(&s[0][0], CALLERS * N, M);
    for (int round = 0; round < 3; round++) {
#pragma omp parallel for
        for (int c = 0; c < CALLERS; c++)
            scatter(h[c], s[c], N - round);
        CASE_PRINT(h);
        scatter(h[0], s[0], N);
        CASE_PRINT(h);
    }
    return 0;
}
