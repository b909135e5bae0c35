/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * y += A x for a symmetric sparse matrix that stores only its upper half, by rows: each entry
 * a(i,j) adds to y[i] and, mirrored, to y[j]. The matrix is that of a 600 x 600 grid. Prints a
 * checksum of all bits of y, and on standard error the seconds that it took.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SIDE = 600, ROWS = SIDE * SIDE, RUNS = 60 };

/* The loop that redcc parallelises: entries of other rows also update y[i] and y[j]. */
static void multiply(int n, const int *first, const int *column, const double *a, const double *x,
                     double *y) {
    for (int i = 0; i < n; i++)
        for (int k = first[i]; k < first[i + 1]; k++) {
            const int j = column[k];
            y[i] += a[k] * x[j];
            if (j != i)
                y[j] += a[k] * x[i];
        }
}

/* Fills the upper half of a five-point stencil's matrix: the diagonal, the right and the lower
 * neighbour. Returns the number of entries. */
static int fill_grid(int *first, int *column, double *a) {
    int entries = 0;
    for (int i = 0; i < ROWS; i++) {
        first[i] = entries;
        const int neighbours[] = {i, i % SIDE + 1 < SIDE ? i + 1 : -1,
                                  i + SIDE < ROWS ? i + SIDE : -1};
        for (int k = 0; k < 3; k++)
            if (neighbours[k] >= 0) {
                column[entries] = neighbours[k];
                a[entries++] = k == 0 ? 0.2 : -0.05 / (1 + (i + k) % 7);
            }
    }
    return first[ROWS] = entries;
}

static double seconds_now(void) {
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(void) {
    int *first = malloc((ROWS + 1) * sizeof *first), *column = malloc(3 * ROWS * sizeof *column);
    double *a = malloc(3 * ROWS * sizeof *a);
    double *x = malloc(ROWS * sizeof *x), *y = calloc(ROWS, sizeof *y);
    if (!first || !column || !a || !x || !y)
        return 1;
    fill_grid(first, column, a);
    for (int i = 0; i < ROWS; i++)
        x[i] = 1.0 / (1 + i % 1000);
    const double begin = seconds_now();
    for (int run = 0; run < RUNS; run++)
        multiply(ROWS, first, column, a, x, y);
    fprintf(stderr, "%.3f s\n", seconds_now() - begin);
    uint64_t sum = 0, bits;
    for (int i = 0; i < ROWS; i++) {
        memcpy(&bits, &y[i], sizeof bits);
        sum = sum * 31 + bits;
    }
    printf("spmv %016llx\n", (unsigned long long)sum);
    free(first), free(column), free(a), free(x), free(y);
    return 0;
}
