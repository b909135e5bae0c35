/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Sparse matrices in coordinate form, transposed products, symmetric products, and chains of subscripts.
// covers: row 26, row 7 of docs/constructs.md
// CFLAGS: -march=native
#include "case.h"

enum { ROWS = 1500, NONZEROS = 12000 };
static int row[NONZEROS], column[NONZEROS], start[ROWS + 1], permuted[ROWS];
static double value_of[NONZEROS], x[ROWS], y[ROWS], z[ROWS], w[ROWS][3];

static void coordinates(int nonzeros) {
    for (int k = 0; k < nonzeros; k++) // EXPECT: transformed
        y[row[k]] += value_of[k] * x[column[k]];
}

static void transposed(int rows) {
    for (int i = 0; i < rows; i++) { // EXPECT: transformed
        const double xi = x[i];
        for (int k = start[i]; k < start[i + 1]; k++)
            z[column[k]] += value_of[k] * xi;
    }
}

/* As in Spark98: the row's sum, and a contribution to each column's element. */
static void symmetric(int rows) {
    for (int i = 0; i < rows; i++) { // EXPECT: transformed
        double sum0 = 0.0, sum1 = 0.0;
        int k = start[i];
        const int last = start[i + 1];
        while (k < last) {
            const int c = column[k];
            sum0 += value_of[k] * x[c];
            sum1 += value_of[k] * x[c] * 0.5;
            w[c][0] += value_of[k] * x[i];
            w[c][1] -= value_of[k] * x[i];
            k++;
        }
        w[i][0] += sum0;
        w[i][1] += sum1;
    }
}

static void chained(int nonzeros) {
    for (int k = 0; k < nonzeros; k++) // EXPECT: transformed
        y[permuted[row[k]]] += value_of[k];
}

int main(void) {
    case_values(value_of, NONZEROS);
    case_values(x, ROWS);
    for (int round = 0; round < 3; round++) {
        case_near_subscripts(row, NONZEROS, ROWS);
        case_subscripts(column, NONZEROS, ROWS);
        for (int i = 0; i <= ROWS; i++)
            start[i] = i * (NONZEROS / ROWS);
        for (int i = 0; i < ROWS; i++)
            permuted[i] = (i * 7 + round) % ROWS;
        coordinates(NONZEROS);
        transposed(ROWS);
        symmetric(ROWS);
        chained(NONZEROS);
        CASE_PRINT(y);
        CASE_PRINT(z);
        CASE_PRINT(w);
    }
    return 0;
}
