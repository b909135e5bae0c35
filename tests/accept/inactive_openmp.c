/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// OpenMP directives in branches that the preprocessor omits: above loops, in them and elsewhere in the
// function. redcc analyses the text that is compiled. A macro's name may end in _OPENMP.
// covers: row 3 of docs/constructs.md
// covers: row 55 of docs/constructs.md
#include "case.h"

enum { N = 9000, M = 700, MOST = 6 };
static int begin[N + 1], column[N * MOST];
static double value[N * MOST], x[N], y[M], sums[M];

static int team = 1;
static int threads(void) {
    return team;
}

/* Multiplies by the transposed matrix, in the form used by a solver library. */
static int transposed(int rows, int vectors, const int *first, const int *col, const double *a,
                      const double *in, double *out, double *expanded) {
    int i, j, jj, jv, offset = 0;
    const int count = threads();
#ifdef USING_OPENMP
#pragma omp parallel for private(i, jj)
#endif
    for (i = 0; i < rows; i++) { // EXPECT: transformed
        for (jj = first[i]; jj < first[i + 1]; jj++)
            sums[col[jj]] += a[jj];
    }
    if (count > 1) {
#ifdef USING_OPENMP
#pragma omp parallel private(i, jj, j, offset)
#endif
        {
            offset = count * rows;
#ifdef USING_OPENMP
#pragma omp for schedule(static)
#endif
            for (i = 0; i < rows; i++) { // EXPECT: transformed
                for (jj = first[i]; jj < first[i + 1]; jj++) {
                    j = col[jj];
                    expanded[offset + j] += a[jj] * in[i];
                }
            }
        }
    } else {
        for (i = 0; i < rows; i++) { // EXPECT: transformed
            if (vectors == 1) {
                for (jj = first[i]; jj < first[i + 1]; jj++) {
                    j = col[jj];
                    out[j] += a[jj] * in[i];
                }
            } else {
                for (jv = 0; jv < vectors; ++jv) {
#if defined(USING_OPENMP) && !defined HAVE_OPENMP_4
#pragma omp atomic
#endif
                    for (jj = first[i]; jj < first[i + 1]; jj++)
                        out[col[jj]] += a[jj] * in[i] * jv;
                }
            }
        }
    }
    return offset;
}

int main(void) {
    int n = 0;
    for (int i = 0; i < N; i++) {
        begin[i] = n;
        n += case_below(MOST);
    }
    begin[N] = n;
    case_values(value, n);
    case_values(x, N);
    case_subscripts(column, n, M);
    for (int round = 0; round < 5; round++) {
        transposed(N - round, 1 + round % 3, begin, column, value, x, y, NULL);
        CASE_PRINT(y);
        CASE_PRINT(sums);
    }
    return 0;
}
