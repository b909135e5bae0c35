/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The force loop of the paper's figure 4: each triangle's force updates the vector b and blocks of the matrix A.
// covers: row 20, row 47, row 58, row 59 of docs/constructs.md
// THREADS: 1 2 3 7 16 33
// CFLAGS: -march=native
#include "case.h"
#include <math.h>

enum { PARTICLES = 90, FORCES = 6000 };

static int ListForce[FORCES][3];
static double x[PARTICLES][3];
static double b[PARTICLES][3];
static double A[PARTICLES][PARTICLES][3][3];

static void computeForce(int i, int j, int k, double f[3][3]) {
    for (int c = 0; c < 3; c++) {
        double u = x[j][c] - x[i][c], v = x[k][c] - x[i][c];
        f[0][c] = u * v + 0.25 * u;
        f[1][c] = u - 0.5 * v;
        f[2][c] = -f[0][c] - f[1][c];
    }
}

static void calcDerivsF(int i, int j, int k, double df[3][3][3][3]) {
    int p, q, c, d;
    for (p = 0; p < 3; p++)
        for (q = 0; q < 3; q++)
            for (c = 0; c < 3; c++)
                for (d = 0; d < 3; d++)
                    df[p][q][c][d] = x[i][c] * x[j][d] + (p == q ? 2.0 : -1.0) * x[k][c];
}

static void evaluateForces(int numForces) {
    int cont, i, j, k, c, d;
    double f[3][3], df[3][3][3][3];

    for (cont = 0; cont < numForces; cont = cont + 1) // EXPECT: transformed
    {
        i = ListForce[cont][0]; /* related particles */
        j = ListForce[cont][1];
        k = ListForce[cont][2];
        computeForce(i, j, k, f);
        calcDerivsF(i, j, k, df);
        for (c = 0; c < 3; c++) {
            b[i][c] = b[i][c] + f[0][c]; /* right-hand side vector b */
            b[j][c] = b[j][c] + f[1][c];
            b[k][c] = b[k][c] + f[2][c];
            for (d = 0; d < 3; d++) {
                A[i][i][c][d] = A[i][i][c][d] + df[0][0][c][d]; /* system matrix A */
                A[i][j][c][d] = A[i][j][c][d] + df[0][1][c][d];
                A[i][k][c][d] = A[i][k][c][d] + df[0][2][c][d];
                A[j][i][c][d] = A[j][i][c][d] + df[1][0][c][d];
                A[j][j][c][d] = A[j][j][c][d] + df[1][1][c][d];
                A[j][k][c][d] = A[j][k][c][d] + df[1][2][c][d];
                A[k][i][c][d] = A[k][i][c][d] + df[2][0][c][d];
                A[k][j][c][d] = A[k][j][c][d] + df[2][1][c][d];
                A[k][k][c][d] = A[k][k][c][d] + df[2][2][c][d];
            }
        }
    }
}

int main(void) {
    case_values(&x[0][0], PARTICLES * 3);
    for (int round = 0; round < 4; round++) {
        if (round % 2 == 0) /* every second round repeats the subscripts */
            case_near_subscripts(&ListForce[0][0], FORCES * 3, PARTICLES);
        evaluateForces(FORCES - round);
        CASE_PRINT(b);
        CASE_PRINT(A);
    }
    return 0;
}
