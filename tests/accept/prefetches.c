/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Executors prefetch what later iterations touch, the farther ahead the shorter iterations are: from
// lists of iterations, past the ends of runs, under conditions and past `continue`.
// METHODS: expansion pseudo-expansion dwa-lip pe-dwa-lip:2
// INTEGERS: no
#include "case.h"

#include <math.h>

enum { NODES = 700, ELEMENTS = 1900 };
static int corner[ELEMENTS][3], block[ELEMENTS][6], active[ELEMENTS];
static double place[NODES][3], force[NODES][3], matrix[4 * NODES][3][3], weight[ELEMENTS][3];

static void element(const double (*x)[3], int i, int j, int k, const double w[3], double f[3][3],
                    double df[6][3][3]) {
    double u[3], length = 1.0;
    for (int c = 0; c < 3; c++) {
        u[c] = w[0] * x[i][c] + w[1] * x[j][c] + w[2] * x[k][c];
        length += u[c] * u[c];
    }
    length = sqrt(length);
    for (int p = 0, q = 0; p < 3; p++) {
        for (int c = 0; c < 3; c++)
            f[p][c] = w[p] * u[c] / length;
        for (int o = p; o < 3; o++, q++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    df[q][r][c] = w[p] * w[o] * ((r == c) - u[r] * u[c] / (length * length));
    }
}

static void declared_inside(int n, const double (*restrict x)[3], const double (*restrict w)[3],
                            double (*b)[3], double (*a)[3][3]) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = corner[t][0], j = corner[t][1], k = corner[t][2];
        double f[3][3], df[6][3][3];
        element(x, i, j, k, w[t], f, df);
        for (int c = 0; c < 3; c++) {
            b[i][c] += f[0][c];
            b[j][c] += f[1][c];
            b[k][c] += f[2][c];
        }
        for (int q = 0; q < 6; q++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    a[block[t][q]][r][c] += df[q][r][c];
    }
}

static void declared_outside(int n, const double (*x)[3], const double (*restrict w)[3],
                             double (*b)[3]) {
    double f[3][3], df[6][3][3];
    int t, i, j, k;
    for (t = n - 1; t >= 0; t -= 3) { // EXPECT: transformed
        i = corner[t][0];
        j = corner[t][1];
        k = corner[t][2];
        element(x, i, j, k, w[t], f, df);
        for (int q = 0; q < 6; q++)
            for (int c = 0; c < 3; c++)
                b[q % 2 ? i : q < 3 ? j : k][c] -= df[q][c][0] + f[q / 2][c];
    }
}

/* The row to prefetch has a subscript that the inspector declares inside a block. */
static void declared_behind_a_loop(int n, const double (*restrict x)[3], const double (*restrict w)[3],
                                   double (*b)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double f[3][3], df[6][3][3];
        for (int c = 0; c < 5; c++) {
            int k = block[t][c] % NODES;
            if (active[t] & 4)
                k = (k + 3) % NODES;
            b[k][2] += w[t][0];
        }
        const int i = corner[t][2];
        element(x, i, i, i, w[t], f, df);
        for (int c = 0; c < 3; c++)
            b[i][c] += df[c][0][c] + f[c][c];
    }
}

static void left_early(int n, const double (*restrict x)[3], const double (*restrict w)[3],
                       double (*b)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (active[t] % 3 == 0)
            continue;
        const int i = corner[t][0];
        double f[3][3], df[6][3][3];
        element(x, i, i, i, w[t], f, df);
        if (active[t] % 3 == 1)
            for (int q = 0; q < 6; q++)
                for (int c = 0; c < 3; c++)
                    b[i][c] += df[q][0][c];
    }
}

static void light(int n, const double (*restrict x)[3], const double (*restrict w)[3],
                  double (*b)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = corner[t][0], j = corner[t][1];
        for (int c = 0; c < 3; c++) {
            b[i][c] += w[t][c] * (x[j][c] - x[i][c]);
            b[j][c] -= w[t][c] * (x[j][c] - x[i][c]);
        }
    }
}

int main(void) {
    setenv("REDCC_PREFETCH", "on", 1);
    for (int t = 0; t < ELEMENTS; t++) {
        for (int p = 0; p < 3; p++)
            corner[t][p] = case_below(NODES);
        for (int q = 0; q < 6; q++)
            block[t][q] = case_below(4 * NODES);
        active[t] = case_below(6);
    }
    case_values(&place[0][0], 3 * NODES);
    case_values(&weight[0][0], 3 * ELEMENTS);
    for (int call = 0; call < 3; call++) {
        declared_inside(ELEMENTS, (const double(*)[3])place, (const double(*)[3])weight, force,
                        matrix);
        declared_outside(ELEMENTS, (const double(*)[3])place, (const double(*)[3])weight, force);
        declared_behind_a_loop(ELEMENTS, (const double(*)[3])place, (const double(*)[3])weight, force);
        left_early(ELEMENTS, (const double(*)[3])place, (const double(*)[3])weight, force);
        light(ELEMENTS, (const double(*)[3])place, (const double(*)[3])weight, force);
    }
    case_print("force", force, sizeof force);
    case_print("matrix", matrix, sizeof matrix);
    return 0;
}
