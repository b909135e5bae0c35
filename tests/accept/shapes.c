/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Two-dimensional and variable-length arrays, linear subscripts and shifted subscripts.
// covers: row 47, row 50, row 51, row 2 of docs/constructs.md
#include "case.h"

enum { N = 15000, M = 800 };
static int s[N], r[N];
static double w[N];
static double pairs[M][2], flat[3 * M], square[40][50];

#define AT(i, c) ((i)*3 + (c))
#define ADD(target, value) target += (value)

static void rows(double (*p)[2], int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p[s[t]][0] += w[t];
        p[s[t]][1] -= w[t];
    }
}

static void linear(double *f, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        f[3 * s[t]] += w[t];
        f[s[t] * 3 + 1] += 2.0 * w[t];
        f[AT(s[t], 2)] += 3.0 * w[t];
    }
}

static void variable(int rows_of, int columns, double v[rows_of][columns], int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        v[r[t]][s[t] % columns] += w[t];
}

static void two_subscripts(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        square[r[t]][s[t] % 50] += w[t];
}

__attribute__((noipa)) static void shifted(double *h, int least, int n) {
    double *one_based = h - 1;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t] + 1000 - least] += w[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        ADD(one_based[s[t] + 1], w[t]);
}

int main(void) {
    static double area[M];
    double(*v)[25] = malloc(40 * sizeof *v);
    for (int i = 0; i < 40; i++)
        for (int j = 0; j < 25; j++)
            v[i][j] = 0;
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        case_subscripts(r, N, 40);
        rows(pairs, N);
        linear(flat, N);
        variable(40, 25, v, N);
        two_subscripts(N);
        shifted(area, 1000, N);
        CASE_PRINT(pairs);
        CASE_PRINT(flat);
        case_print("v", v, 40 * sizeof *v);
        CASE_PRINT(square);
        CASE_PRINT(area);
    }
    free(v);
    return 0;
}
