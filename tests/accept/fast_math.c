/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// With -ffast-math two copies of a subscript's computation may differ: the loop runs sequentially.
// covers: row 33 of docs/constructs.md
// CFLAGS: -ffast-math
// MAY-RUN-SERIALLY: -ffast-math requires it
// METHODS: expansion
#include "case.h"

enum { N = 20000, BINS = 500 };
static double x[N];
static int h[BINS];

static void histogram(int n, double low, double scale) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[(int)((x[t] - low) * scale)]++;
}

int main(void) {
    for (int i = 0; i < N; i++)
        x[i] = (double)case_below(1 << 20) / (1 << 20);
    for (int round = 0; round < 3; round++) {
        histogram(N - round, 0.0, BINS);
        CASE_PRINT(h);
    }
    return 0;
}
