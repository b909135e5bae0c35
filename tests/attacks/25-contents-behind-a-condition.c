/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// x[...] is read after `&&` or in a branch of `?:` in the update's own condition. When a plan is reused,
// only elements that the program reads may be compared.
#include <stdio.h>

enum { N = 400 };
static double memory[4 * N];
static int k[N];

__attribute__((noipa)) static void chosen(unsigned n, const double *x, double *h, const int *k) {
    for (unsigned t = 0; t < n; t++) { // EXPECT: transformed
        if ((t * 0x10001u + 48u < 114u ? x[t * 0x10001u + 48u] : 1) > 0.125)
            h[k[t]] += 1.5;
    }
}

__attribute__((noipa)) static void both(unsigned n, const double *x, double *h, const int *k) {
    for (unsigned t = 0; t < n; t++) { // EXPECT: transformed
        if (t * 0x90000000u + 21u < 302u && x[t * 0x90000000u + 21u] > 0.125)
            h[k[t]] += 1.5;
    }
}

__attribute__((noipa)) static void straight(unsigned n, const double *x, double *h, const int *k) {
    for (unsigned t = 0; t < n; t++) // EXPECT: parallel
        if (x[t] > 0.125)
            h[k[t]] += 1.5;
}

int main(void) {
    for (int i = 0; i < N; i++)
        k[i] = (int)((i * 2654435761u) % (N - 9));
    for (int i = 0; i < 4 * N; i++)
        memory[i] = 1.0 / (i + 1);
    for (int r = 0; r < 3; r++) {
        chosen(N, memory, memory + 2 * N, k);
        both(N, memory, memory + 2 * N, k);
        straight(N, memory, memory + 2 * N, k);
    }
    double sum = 0;
    for (int i = 0; i < 4 * N; i++)
        sum += memory[i] * (i % 7);
    printf("%a\n", sum);
    return 0;
}
