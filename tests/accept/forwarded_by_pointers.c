/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// An iteration stores elements and reads them again, through pointers without restrict. Nothing else is
// written between store and read. So the value read is the value stored, even if the arrays overlap.
// covers: row 31 of docs/constructs.md
// covers: row 59 of docs/constructs.md
// INTEGERS: no
// MAY-RUN-SERIALLY: arrays overlap in some calls
#include "case.h"

enum { N = 9000, CELLS = 30 };
static double x[N][3], mass[N];
static int cell[N], count[CELLS * CELLS * CELLS + 1], pool[2 * N];
static float length[N], sums[CELLS];

static void count_cells(int n, const double (*at)[3], double edge, int *c, int *number) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        int k[3];
        for (int d = 0; d < 3; d++)
            k[d] = (int)((at[i][d] + 1) / edge);
        c[i] = (k[0] * CELLS + k[1]) * CELLS + k[2];
        number[c[i]]++;
    }
}

static void several(int n, const int *key, float *l, float *s, int *c, const double *w) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        c[i] = key[i] % CELLS;
        l[i] = (float)(w[i] * w[i]);
        s[c[i]] += l[i] * 0.5f;
        s[c[i]] -= 1;
    }
}

int main(void) {
    case_values(mass, N);
    for (int round = 0; round < 6; round++) {
        case_values(&x[0][0], 3L * N);
        case_subscripts(pool, 2 * N, 400);
        const double edge = 2.0 / (CELLS - 1);
        count_cells(N - round, (const double(*)[3])x, edge, cell, count);
        several(N, pool, length, sums, cell, mass);
        CASE_PRINT(cell);
        CASE_PRINT(count);
        CASE_PRINT(length);
        CASE_PRINT(sums);
        if (round < 3)
            continue;
        /* coarse cells: the counts lie within the array of cell numbers or next to it */
        count_cells(N / 2, (const double(*)[3])x, 0.9, pool, pool + 100 * round);
        count_cells(N / 2, (const double(*)[3])x, 0.9, pool + 900, pool);
        several(N / 2, pool, length, length + 7, pool + N, mass);
        several(N / 2, pool, length + 20, length, pool, mass);
        CASE_PRINT(pool);
        CASE_PRINT(length);
    }
    return 0;
}
