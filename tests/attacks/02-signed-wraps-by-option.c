/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fwrapv
// THREADS: 1 3
// int subscripts that wrap around in the middle of the loop, as -fwrapv permits. The rows read lie at both
// ends of 4 GB, and the rows at the lower end are updated.
#include <limits.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

enum { N = 3000, ROWS = 64, LENGTH = 8 };
static int k[N], first[N];

#define KEEP __attribute__((noipa)) static

KEEP void ends(int n, int from, const signed char *x, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += 0.1 * x[t + from];
}

KEEP void multiples(int n, int factor, const signed char *x, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += 0.1 * x[t * factor + 1];
}

KEEP void spans(int n, int m, const signed char *x, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double sum = 0;
        for (int c = 0; c < m; c++)
            sum += x[first[t] + c];
        h[k[t]] += 0.1 * sum;
    }
}

KEEP void widened(int n, int from, const signed char *x, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += 0.1 * x[(long)(t + from) + 1];
}

/* The counter may pass INT_MAX and continue at INT_MIN. */
KEEP void counters(int n, int step, double *h) {
    for (int t = n - 3; t <= n; t++) // EXPECT: refuse counter-wraps
        h[k[t & 7]] += 1;
    for (int t = n - 3; t < n; t += step) // EXPECT: refuse counter-wraps
        h[k[t & 7]] += 1;
    for (int t = n - 3; t + 2 < n; t++) // EXPECT: refuse trip-count
        h[k[t & 7]] += 1;
    for (int t = n - 3; t != n; t++) // EXPECT: refuse counter-wraps
        h[k[t & 7]] += 1;
    for (int t = 3; t--;) // EXPECT: refuse counter-wraps
        h[k[t & 7]] += 1;
}

static void show(const char *name, double *h) {
    printf("%s:", name);
    for (int r = 0; r < ROWS; r++)
        printf(" %a", h[r]);
    printf("\n");
    memset(h, 0, ROWS * sizeof *h);
}

int main(void) {
    const size_t bytes = ((size_t)1 << 32) + (1 << 16);
    char *whole = mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (whole == MAP_FAILED)
        return 1;
    signed char *x = (signed char *)whole - (long)INT_MIN; /* x[INT_MIN] is whole[0] */
    double *h = (double *)whole;
    for (int t = 0; t < N; t++) {
        k[t] = t * 7919 % ROWS;
        first[t] = INT_MAX - t % 11;
        x[INT_MAX - t] = (signed char)(t % 100);
    }
    ends(N, INT_MAX - N / 3, x, h);
    show("ends", h);
    multiples(N, INT_MAX, x, h);
    show("multiples", h);
    spans(N, LENGTH, x, h);
    show("spans", h);
    widened(N, INT_MAX - N / 3, x, h);
    show("widened", h);
    counters(INT_MAX - 10, 2, h);
    show("counters", h);
    return 0;
}
