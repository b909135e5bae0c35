/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A function reads a[i * j], where i and j are the counters of its loops. So the range of x that it
// reads ends at the product of the largest counters, and this element may be in h.
#include <stdio.h>

enum { N = 4000, LAST = 36 };
static double memory[2 * N];
static int k[N];

static double products(const double *a) {
    double sum = 0;
    for (int i = 0; i < 7; i++)
        for (int j = 0; j < 7; j++)
            sum += a[i * j];
    return sum;
}

__attribute__((noipa)) static void scattered(int n, const double *x, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += 1e-3 * products(x) + t;
}

__attribute__((noipa)) static void straight(int n, const double *x, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += x[t];
}

int main(void) {
    for (int i = 0; i < N; i++)
        k[i] = (int)((i * 2654435761u) % N);
    for (int i = 0; i < 2 * N; i++)
        memory[i] = 1.0 / (i + 1);
    for (int r = 0; r < 3; r++)
        scattered(N, memory, memory + LAST); /* the last element read is h[0] */
    for (int r = 0; r < 3; r++)
        straight(N, memory, memory + N);
    double sum = 0;
    for (int i = 0; i < 2 * N; i++)
        sum += memory[i] * (i % 7);
    printf("%a\n", sum);
    return 0;
}
