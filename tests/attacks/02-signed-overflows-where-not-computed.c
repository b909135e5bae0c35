/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// t * stride would overflow in the last iterations, which do not compute it. The extent of x must
// not be taken from these values, and the inspector must not compute them.
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>

enum { N = 4000, STRIDE = 600000 };
static int k[N];

#define KEEP __attribute__((noipa)) static

KEEP void chosen(int n, int m, int stride, const double *x, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double v = 1.0;
        if (t < m)
            v += x[t * stride];
        h[k[t]] += v;
    }
}

KEEP void marked(int n, const int *mark, int stride, const double *x, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double v = 1.0;
        if (mark[t])
            v += x[t * stride];
        h[k[t]] += v;
    }
}

KEEP void long_product(long n, long m, long stride, const double *x, double *h) {
    for (long t = 0; t < n; t++) { // EXPECT: transformed
        double v = 1.0;
        if (t < m)
            v += x[t * stride];
        h[k[t]] += v;
    }
}

KEEP void invariant(int n, int m, int a, int b, const double *x, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double v = 1.0;
        if (t < m)
            v += x[a * b];
        h[k[t]] += v;
    }
}

/* the row of an update under a floating-point condition that the inspector leaves out */
KEEP long updated(int n, const double *w, const int *i, int a, double *h) {
    long beyond = 0;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        if (w[t] * w[t] < 0.25)
            h[i[t] + a] += w[t];
        beyond += i[t] > N;
    }
    return beyond;
}

/* a span whose last elements are neither updated nor computed */
KEEP void along(int n, int m, int from, const double *w, signed char *h) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const int row = from - k[t] % 2;
        for (int c = 0; c < m; c++)
            if (w[c] * 2.0 < 1.0)
                h[row + c] = (signed char)(h[row + c] * 3 + t);
    }
}

/* t + from overflows after the first m iterations, which alone read x */
KEEP void at_the_end(int n, int m, int from, const signed char *x, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double v = 1.0;
        if (t < m)
            v += x[t + from];
        h[k[t] % 370] += v;
    }
}

KEEP void straight(int n, int stride, const double *x, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += x[t * stride];
}

KEEP void some(int n, int m, int stride, const double *x, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        if (t > m)
            continue;
        h[k[t]] += x[t * stride];
    }
}

static void far(const double *w) {
    signed char *all = mmap(NULL, ((size_t)1 << 31) + 65536, PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (all == MAP_FAILED)
        return;
    for (int r = 0; r < 3; r++)
        along(N, 7, INT_MAX - 1, w, all);
    const int from = INT_MAX - N + N / 4;
    double *h = (double *)(all + from / 8 * 8 + 8);
    for (int i = 0; i < 370; i++)
        h[i] = i;
    for (int i = 0; i < N; i++)
        k[i] = (int)(i * 2654435761u % 8191);
    for (int r = 0; r < 3; r++)
        at_the_end(N, N - N / 4, from, all, h);
    double sum = 0;
    for (int i = 0; i < 370; i++)
        sum += h[i] * (i % 7);
    printf("%a\n", sum);
    printf("%d %d %d\n", all[INT_MAX - 2], all[INT_MAX - 1], all[INT_MAX]);
}

int main(void) {
    static int mark[N];
    static double w[N];
    double *memory = malloc(sizeof(double) * 3 * STRIDE);
    for (int i = 0; i < 3 * STRIDE; i++)
        memory[i] = 1.0 / (i + 1);
    for (int i = 0; i < N; i++) {
        k[i] = (int)((i * 2654435761u) % (N - 9));
        mark[i] = i < 3;
        w[i] = i % 3 ? 0.75 : 0.25;
    }
    for (int r = 0; r < 3; r++) {
        chosen(N, 3, STRIDE, memory, memory + STRIDE);
        chosen(N, 1, INT_MAX - 7, memory + 8, memory + 4);
        marked(N, mark, STRIDE, memory, memory + STRIDE);
        long_product(N, 3, STRIDE, memory, memory + STRIDE);
        long_product(N, 1, LONG_MAX / 3, memory, memory);
        invariant(N, 0, INT_MAX, 3, memory, memory);
        invariant(N, 9, 2, 3, memory, memory);
        updated(N / 4, w + 1, k, 0, memory);
        straight(N / 4, 2, memory + 2 * STRIDE, memory);
        some(N, N / 2, 2, memory + 2 * STRIDE, memory);
    }
    for (int i = 0; i < N; i++) {
        w[i] = i % 3 || i > N / 2 ? 0.75 : 0.25;
        if (i % 3 == 1)
            k[i] = INT_MAX - i;
    }
    for (int r = 0; r < 3; r++)
        printf("%ld\n", updated(N, w, k, 5 * N, memory));
    for (int i = 0; i < N; i++)
        w[i] = i < 2 ? 0.25 : 0.75;
    far(w);
    double sum = 0;
    for (int i = 0; i < 3 * STRIDE; i++)
        sum += memory[i] * (i % 7);
    printf("%a\n", sum);
    return 0;
}
