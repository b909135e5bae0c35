/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A sparse matrix in compressed columns times a vector, as in CSparse's cs_gaxpy. The vectors are
// disjoint or equal, or overlap each other or the matrix's values.
// MAY-RUN-SERIALLY: in some calls the arrays overlap
#include "case.h"
#include <stddef.h>

typedef ptrdiff_t csi;
typedef struct matrix {
    csi nzmax, m, n;
    csi *p, *i;
    double *x;
    csi nz;
} cs;
#define CSC(A) (A && (A->nz == -1))

static csi gaxpy(const cs *A, const double *x, double *y) {
    csi p, j, n, *Ap, *Ai;
    double *Ax;
    if (!CSC(A) || !x || !y)
        return (0);
    n = A->n;
    Ap = A->p;
    Ai = A->i;
    Ax = A->x;
    for (j = 0; j < n; j++) { // EXPECT: transformed
        for (p = Ap[j]; p < Ap[j + 1]; p++) {
            y[Ai[p]] += Ax[p] * x[j];
        }
    }
    return (1);
}

enum { N = 1500, PER_COLUMN = 7, ENTRIES = N * PER_COLUMN };
static csi starts[N + 1], rows[ENTRIES];
static double memory[ENTRIES + 2 * N];

static void banded(void) {
    for (csi k = 0; k < ENTRIES; k++) {
        const csi row = k / PER_COLUMN + case_below(41) - 20;
        rows[k] = row < 0 ? 0 : row >= N ? N - 1 : row;
    }
}

static void scattered(void) {
    for (csi k = 0; k < ENTRIES; k++)
        rows[k] = case_below(N);
}

/* Multiplies; the arguments are the offsets of values, x and y in `memory`. */
static void product(int values, int x, int y) {
    const cs a = {ENTRIES, N, N, starts, rows, memory + values, -1};
    case_values(memory, ENTRIES + 2 * N);
    for (int i = 0; i < ENTRIES + 2 * N; i++)
        memory[i] *= 0.25; /* keeps y = A*y + y small */
    for (int call = 0; call < 2; call++)
        gaxpy(&a, memory + x, memory + y);
    CASE_PRINT(memory);
}

int main(void) {
    void (*const patterns[2])(void) = {banded, scattered};
    for (csi j = 0; j <= N; j++)
        starts[j] = j * PER_COLUMN;
    for (int pattern = 0; pattern < 2; pattern++) {
        patterns[pattern]();
        product(2 * N, 0, N);            /* disjoint */
        product(2 * N, N, N);            /* x is y */
        product(2 * N, N - 1, N);        /* x ends one element before y does */
        product(2 * N, N, N - 1);        /* x begins one element before y ends */
        product(2 * N, 1, N);            /* one element in common */
        product(N + N / 2, 0, N);        /* y overlaps the values */
        product(0, ENTRIES - 1, ENTRIES + N); /* x overlaps the values: the loop only reads them */
    }
    return 0;
}
