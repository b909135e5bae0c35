/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Pointers that advance through copies walk into the updated array, only in the last rows or behind its end. The
// copy is set in two places, so its value is not that of a single definition.
#include <stdio.h>

enum { N = 3000, M = 4, ALL = 3 * N * M };
static int s[N];
static double e[ALL];

static long walk(double *rows, double *out, int n, int m) {
    double *r0 = rows, *r1 = rows;
    r1 += m;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        r1 = r0 + m;
        out[s[i]] += r0[1] * 0.5 - r1[0] * 0.25;
        r0 = r1 + m;
    }
    return r1 - rows;
}

static long columns(double *rows, double *out, int n, int m) {
    double *r0 = rows, *r1 = rows;
    r1 += m;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        r1 = r0 + m;
        for (int k = 0; k < m; k++)
            out[s[i]] += r1[k] * 0.125 - r0[k] * 0.25;
        r0 = r1 - m + 1;
    }
    return r0 - rows;
}

int main(void) {
    unsigned x = 7;
    long sum = 0;
    for (int i = 0; i < ALL; i++)
        e[i] = (double)((x = x * 1664525u + 1013904223u) >> 8) / (1 << 24);
    for (int i = 0; i < N; i++)
        s[i] = (int)((x = x * 1664525u + 1013904223u) >> 8) % 50;
    for (int shift = 2 * N * M - 60; shift < 2 * N * M + 20; shift += 13) {
        sum = 3 * sum + walk(e, e + shift, N, M);
        sum = 3 * sum + columns(e, e + N + M - 60 + shift % 80, N, M);
        sum = 3 * sum + walk(e + ALL - 1 - M, e + ALL - 60, N, -M / 2);
        sum %= 1000003;
        for (int i = 0; i < ALL; i++)
            e[i] = e[i] > 1e6 || e[i] < -1e6 ? 0.5 : e[i];
    }
    printf("%ld\n", sum);
    for (int i = 0; i < ALL; i++)
        printf("%a\n", e[i]);
    return 0;
}
