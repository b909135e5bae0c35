/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A const pointer to a static scalar, and the scalar's value, in one loop. gcc replaces a const
// variable by its initializer, so `seen` becomes `&mark`, even where each thread has its own copy of
// mark.
#include <stdio.h>

enum { N = 4000 };
static double bins[N];
static int k[N];
static const void *entry[N];
static char mark;

__attribute__((noipa)) static void marked(int n, double *h, const int *k) {
    const void *const seen = &mark;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if ((entry[t] == seen) + (mark & 1) == 0)
            continue;
        h[k[t]] += t + 0.5;
    }
}

__attribute__((noipa)) static void straight(int n, double *h, const int *k) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += t + 0.5;
}

int main(void) {
    for (int i = 0; i < N; i++) {
        k[i] = (int)((i * 2654435761u) % N);
        entry[i] = i % 3 ? &mark : NULL;
    }
    for (int r = 0; r < 3; r++) {
        marked(N, bins, k);
        straight(N, bins, k);
    }
    double sum = 0;
    for (int i = 0; i < N; i++)
        sum += bins[i] * (i % 7);
    printf("%a\n", sum);
    return 0;
}
