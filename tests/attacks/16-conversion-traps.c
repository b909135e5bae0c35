/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Operations that may trap or are undefined, each under a condition that is expensive to repeat.
// The inspector must not execute them where the program does not.
#define _GNU_SOURCE
#include <fenv.h>
#include <math.h>
#include <stdio.h>

enum { N = 4000, ROOM = 4200 };
static double x[N], h[ROOM];
static int k[N], d[N];

#define KEEP __attribute__((noipa)) static

KEEP void converted(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = x[t];
        if (v * v < 1e4)
            h[(int)v + 100] += 1.0;
    }
}

KEEP void converted_before(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = x[t];
        if (v * v >= 1e4)
            continue;
        const int i = (int)(v + 0.5);
        h[i + 100] += v;
    }
}

KEEP void converted_silently(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = x[t];
        int i;
        if (v * v >= 1e4)
            continue;
        i = v;
        h[i + 100] += v;
    }
}

KEEP void converted_read(int n, const double *table, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = x[t];
        double w = 2.0;
        if (v * v < 1e4)
            w = table[(int)v + 100];
        to[k[t]] += w;
    }
}

KEEP void called(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = x[t];
        if (v * v < 1e4)
            h[lrint(v) + 100] += 1.0;
    }
}

KEEP void divided(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double v = x[t];
        const int by = d[t];
        if (v * v < 1e4)
            h[1000 / by + 100] += v;
    }
}

KEEP void quotient_before(int n, int m, int by, const double *table, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double w = 2.0;
        if (by)
            w = table[t + m / by];
        to[k[t]] += w;
    }
}

KEEP void plain(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const double v = x[t];
        if (v * v < 1e4)
            h[k[t]] += v;
    }
}

int main(void) {
    for (int i = 0; i < N; i++) {
        k[i] = (int)((i * 2654435761u) % (N - 9));
        x[i] = i % 5 == 3 ? 1e20 : i % 97 - 40.25;
        d[i] = i % 5 == 3 ? 0 : i % 9 + 1;
    }
    feenableexcept(FE_INVALID | FE_DIVBYZERO);
    for (int r = 0; r < 3; r++) {
        converted(N);
        converted_before(N);
        converted_silently(N);
        converted_read(N, x, h);
        called(N);
        divided(N);
        quotient_before(N / 4, 7, 0, x, h);
        quotient_before(N / 4, 7, 2, x, h);
        plain(N);
    }
    fedisableexcept(FE_INVALID | FE_DIVBYZERO); /* until here exceptions trapped, and all loops were sequential */
    plain(N);
    double sum = 0;
    for (int i = 0; i < ROOM; i++)
        sum += h[i] * (i % 7);
    printf("%a\n", sum);
    return 0;
}
