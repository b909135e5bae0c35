/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Nests that call functions which make the updates: the inner loops set the range of the subscripts.
// covers: row 17 of docs/constructs.md
// COMPILERS: gcc clang-19
// INTEGERS: no
#include "case.h"

enum { N = 900, ROWS = 4000 };
static double x[N][3], f[N][3], potential[N], h[N];
static int first[ROWS], node[4 * ROWS];

static void add(double *p, double v) {
    *p += v;
}

static void add_at(double *p, int i, double v) {
    p[i] += v;
}

static void add_row(double *p, double s, const double *d) {
    for (int c = 0; c < 3; c++)
        p[c] += s * d[c];
}

static void by_address(int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++) {
            const double v = 1.0 / (0.1 + (x[i][0] - x[j][0]) * (x[i][0] - x[j][0]));
            add(&potential[i], v);
            add(potential + j, v);
        }
}

static void by_element(int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++)
            add(&potential[j], x[i][2]);
}

static void by_subscript(int n) {
    for (int i = 1; i < n; i++) // EXPECT: transformed
        for (int j = 0; j < i; j++)
            add_at(h, j, x[i][1] - x[j][1]);
}

static void rows(int n) {
    double d[3];
    for (int i = 0; i < n - 1; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++) {
            double s = 0.01;
            for (int c = 0; c < 3; c++) {
                d[c] = x[i][c] - x[j][c];
                s += d[c] * d[c];
            }
            add_row(f[i], 1.0 / s, d);
            add_row(f[j], -1.0 / s, d);
        }
}

static void lists(int n) {
    for (int i = 0; i < n - 1; i++) // EXPECT: transformed
        for (int k = first[i]; k < first[i + 1]; k++)
            add_at(h, node[k], x[i % N][2]);
}

static void blocks(int n, int m) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int k = 0; k < m; k++)
            add_at(h, node[i * m + k], x[i % N][0]);
}

int main(void) {
    case_values(&x[0][0], 3 * N);
    case_subscripts(node, 4 * ROWS, N);
    for (int i = 1; i < ROWS; i++)
        first[i] = first[i - 1] + case_below(5);
    for (int round = 0; round < 3; round++) {
        by_address(N - round);
        by_element(N - round);
        by_subscript(N - round);
        rows(N - round);
        lists(ROWS);
        blocks(ROWS, 4 - round);
    }
    CASE_PRINT(potential);
    CASE_PRINT(f);
    CASE_PRINT(h);
    return 0;
}
