/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The slice becomes a function that gets a pointer to an array of the enclosing block. If an
// iteration may read any element, the whole array must be recorded at its own address. The
// address of the pointer, on the worker's stack, would record terabytes and miss elements that
// are read.
// METHODS: auto localwrite
#include <stdio.h>
#include <string.h>

enum { N = 900, K = 300, L = 256 };
static double values[L + N], sums[K], others[N];
static float counts[K];
static double *const other = others;
static int length[N];

static inline double work(double v) {
    return v * v * 0.5 + v / (1 + v * v);
}

static __attribute__((noinline)) void static_array(const long (*from)[3], float *h, double *w,
                                                   double *g) {
    static long e[N + 1][3];
    memcpy(e, from, sizeof e);
    for (int i = 0; i < N; i++) { // EXPECT: parallel
        const double f = other[i] > 2 ? work(other[i]) : work(w[i / 2]);
        const int first = e[i / 2][2] & 127;
        const int count = length[i] & 7;
        for (int c = 2; c <= count; c += 2) {
            h[first - 1 + c] += 0.5 - work(w[e[i + 1][2] & 255]);
            g[first - 1 + c] -= work(w[i / 2]) * work(other[i]);
        }
        h[e[i][0] & 255] -= f - work(w[i]);
    }
}

static __attribute__((noinline)) void automatic_array(const long (*from)[3], float *h, double *w,
                                                      double *g) {
    long e[N + 1][3];
    memcpy(e, from, sizeof e);
    for (int i = 0; i < N; i++) { // EXPECT: parallel
        const double f = other[i] > 2 ? work(other[i]) : work(w[i / 2]);
        const int first = e[i / 2][2] & 127;
        const int count = length[i] & 7;
        for (int c = 2; c <= count; c += 2) {
            h[first - 1 + c] += 0.5 - work(w[e[i + 1][2] & 255]);
            g[first - 1 + c] -= work(w[i / 2]) * work(other[i]);
        }
        h[e[i][0] & 255] -= f - work(w[i]);
    }
}

int main(void) {
    static long e[N + 1][3];
    for (int i = 0; i <= N; i++)
        for (int k = 0; k < 3; k++)
            e[i][k] = (i * 7919L + k * 104729L) % 1000;
    for (int i = 0; i < N; i++) {
        length[i] = i * 31 % 256;
        others[i] = i % 5 * 0.75;
    }
    for (int i = 0; i < L + N; i++)
        values[i] = 1.0 / (1 + i);
    for (int round = 0; round < 8; round++) {
        e[N - 5 - round][2] += 17; /* changes elements that only the inner loops read */
        static_array((const long(*)[3])e, counts, values, sums);
        automatic_array((const long(*)[3])e, counts, values, sums);
    }
    for (int i = 0; i < K; i++)
        printf("%a %a\n", sums[i], counts[i]);
    return 0;
}
