/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The first iteration, where t - 1 wraps around, does not read x[t - 1]. If the extent of x were
// taken from that address, the guard would miss the overlap of x and h.
#include <stdio.h>

enum { N = 4000 };
static double memory[2 * N];
static int k[N];

__attribute__((noipa)) static void shifted(unsigned n, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) { // EXPECT: transformed
        double v = 1.0;
        if (t > 0)
            v = x[t - 1];
        h[k[t]] += v;
    }
}

__attribute__((noipa)) static void straight(unsigned n, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += x[t];
}

int main(void) {
    for (int i = 0; i < N; i++)
        k[i] = (int)((i * 2654435761u) % (N - 9)); /* never the last elements, where a wrong extent would begin */
    for (int i = 0; i < 2 * N; i++)
        memory[i] = 1.0 / (i + 1);
    for (int r = 0; r < 3; r++)
        shifted(N, memory, memory);
    for (int r = 0; r < 3; r++)
        straight(N, memory, memory + N);
    double sum = 0;
    for (int i = 0; i < 2 * N; i++)
        sum += memory[i] * (i % 7);
    printf("%a\n", sum);
    return 0;
}
