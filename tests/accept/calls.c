/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions called in the loop that return results or store them through pointers.
// covers: row 15, row 17 of docs/constructs.md
// COMPILERS: gcc clang-19
// INTEGERS: no
#include "case.h"
#include <math.h>

enum { N = 12000, M = 800 };
static int edge[N][2];
static double x[M][3], b[M][3], h[M];

static double square(double v) {
    return v * v;
}

static double distance(const double *p, const double *q) {
    double sum = 0.0;
    for (int c = 0; c < 3; c++)
        sum += square(p[c] - q[c]);
    return sqrt(sum);
}

static void spring(const double (*at)[3], int i, int j, double *f) {
    const double d = distance(at[i], at[j]);
    for (int c = 0; c < 3; c++)
        f[c] = d > 0.0 ? (at[j][c] - at[i][c]) / d : 0.0;
}

__attribute__((const)) static int folded(int i) {
    return i >= M / 2 ? M - 1 - i : i;
}

static void springs(int n) {
    double f[3];
    int i, j;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        i = edge[t][0];
        j = edge[t][1];
        spring((const double (*)[3])x, i, j, f);
        for (int c = 0; c < 3; c++) {
            b[i][c] += f[c];
            b[j][c] -= f[c];
        }
    }
}

static void lengths(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[folded(edge[t][0])] += fabs(distance(x[edge[t][0]], x[edge[t][1]]));
}

int main(void) {
    case_values(&x[0][0], 3 * M);
    for (int round = 0; round < 3; round++) {
        case_subscripts(&edge[0][0], 2 * N, M);
        springs(N);
        lengths(N);
        CASE_PRINT(b);
        CASE_PRINT(h);
    }
    return 0;
}
