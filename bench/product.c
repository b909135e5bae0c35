/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * For script/bench product: times the product of the cloth's matrix and a vector in two ways. In
 * one, half of the matrix is stored, as in the simulator; in the other, every block is stored. The
 * arguments are, for each mesh, the number of its vertices, that of those on the boundary, and the
 * number of timed products. Before timing, the program checks that both ways
 * give the same product.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "mesh/mesh.h"
#include "system/sparse_product.h"

typedef void product(const block_matrix *A, const double (*x)[3], double (*y)[3]);

/* Computes the row starts of the full matrix. */
static void complete_row_starts(const block_matrix *half, int *row_start) {
    for (int i = 0; i < half->row_count; i++)
        for (int k = half->row_start[i]; k < half->row_start[i + 1]; k++) {
            row_start[i + 1]++;
            if (half->column[k] != i)
                row_start[half->column[k] + 1]++;
        }
    for (int i = 0; i < half->row_count; i++)
        row_start[i + 1] += row_start[i];
}

/* Makes the full matrix, with the blocks on both sides of the diagonal, from the half. Returns 0,
 * or -1 if out of memory. */
static int complete(const block_matrix *half, block_matrix *full) {
    const int rows = half->row_count;
    const size_t blocks = 2 * (size_t)half->block_count - (size_t)rows;
    *full = (block_matrix){.row_count = rows, .block_count = (int)blocks};
    full->row_start = calloc((size_t)rows + 1, sizeof *full->row_start);
    full->column = calloc(blocks + 1, sizeof *full->column);
    full->value = calloc(blocks + 1, sizeof *full->value);
    int *next = calloc((size_t)rows + 1, sizeof *next);
    if (!full->row_start || !full->column || !full->value || !next) {
        block_matrix_free(full);
        free(next);
        return -1;
    }
    complete_row_starts(half, full->row_start);
    memcpy(next, full->row_start, sizeof *next * (size_t)rows);
    /* Rows are visited in ascending order. So the transposed blocks of the rows above, which are
     * left of the diagonal, are stored before a row's own blocks, and the columns of each row
     * ascend. */
    for (int i = 0; i < rows; i++)
        for (int k = half->row_start[i]; k < half->row_start[i + 1]; k++) {
            const int j = half->column[k];
            full->column[next[i]] = j;
            memcpy(full->value[next[i]++], half->value[k], sizeof *half->value);
            if (j == i)
                continue;
            full->column[next[j]] = i;
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    full->value[next[j]][r][c] = half->value[k][c][r];
            next[j]++;
        }
    free(next);
    return 0;
}

/* y = F x with every block of F stored: regular accesses, twice the memory of half_product. */
static void full_product(const block_matrix *restrict F, const double (*restrict x)[3],
                         double (*restrict y)[3]) {
    for (int i = 0; i < F->row_count; i++) {
        double y0 = 0, y1 = 0, y2 = 0;
        for (int k = F->row_start[i]; k < F->row_start[i + 1]; k++) {
            const double(*a)[3] = F->value[k];
            const double *xj = x[F->column[k]];
            y0 += a[0][0] * xj[0] + a[0][1] * xj[1] + a[0][2] * xj[2];
            y1 += a[1][0] * xj[0] + a[1][1] * xj[1] + a[1][2] * xj[2];
            y2 += a[2][0] * xj[0] + a[2][1] * xj[1] + a[2][2] * xj[2];
        }
        y[i][0] = y0;
        y[i][1] = y1;
        y[i][2] = y2;
    }
}

/* Are the products of both matrices with x equal, up to rounding? Stores them in y and z. Prints a
 * message if they are not. */
static int agree(const block_matrix *half, const block_matrix *full, const double (*x)[3],
                 double (*y)[3], double (*z)[3]) {
    half_product(half, x, y);
    full_product(full, x, z);
    for (int i = 0; i < half->row_count; i++)
        for (int c = 0; c < 3; c++)
            if (!(fabs(y[i][c] - z[i][c]) <= 1e-12 * fabs(z[i][c]))) {
                fprintf(stderr, "product: row %d is %.17g by half the matrix, %.17g by all of it\n",
                        3 * i + c, y[i][c], z[i][c]);
                return 0;
            }
    return 1;
}

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Returns the median time of one product in seconds. It includes setting y to 0 before the product,
 * which half_product needs. */
static double median_seconds(product *multiply, const block_matrix *A, const double (*x)[3],
                             double (*y)[3], double *seconds, int repeats) {
    for (int n = 0; n < repeats; n++) {
        const double start = clock_seconds();
        for (int i = 0; i < A->row_count; i++)
            y[i][0] = y[i][1] = y[i][2] = 0;
        multiply(A, x, y);
        seconds[n] = clock_seconds() - start;
    }
    qsort(seconds, (size_t)repeats, sizeof *seconds, ascending);
    return seconds[repeats / 2];
}

static void fill(block_matrix *A) {
    for (int k = 0; k < A->block_count; k++)
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++)
                A->value[k][r][c] = 1.0 / (1 + k % 17 + r + c);
}

static double megabytes(const block_matrix *A) {
    return (double)A->block_count * (sizeof *A->value + sizeof *A->column) / 1e6;
}

/* Measures the matrix of the mesh, with or without hinges. Returns 0, or -1 if out of memory or if
 * the products differ. */
static int measure(const mesh *m, int with_hinges, int repeats) {
    const element_list lists[2] = {{m->triangle_count, 3, &m->triangle[0][0]},
                                   {m->hinge_count, 4, &m->hinge[0][0]}};
    linear_system s = {0};
    block_matrix full = {0};
    const size_t n = (size_t)m->vertex_count;
    double(*x)[3] = calloc(n, sizeof *x);
    double(*y)[3] = calloc(n, sizeof *y);
    double(*z)[3] = calloc(n, sizeof *z);
    double *seconds = calloc((size_t)repeats, sizeof *seconds);
    int status = -1;
    if (!x || !y || !z || !seconds ||
        system_init(&s, m->vertex_count, with_hinges ? 2 : 1, lists) != 0)
        goto done;
    fill(&s.A);
    if (complete(&s.A, &full) != 0)
        goto done;
    for (size_t i = 0; i < n; i++)
        x[i][0] = x[i][1] = x[i][2] = 1.0 + (double)(i % 5);
    if (!agree(&s.A, &full, (const double(*)[3])x, y, z))
        goto done;
    const double half =
        median_seconds(half_product, &s.A, (const double(*)[3])x, y, seconds, repeats);
    const double whole =
        median_seconds(full_product, &full, (const double(*)[3])x, y, seconds, repeats);
    printf("%8d %-9s %9d %8.1f %10.1f %9d %8.1f %10.1f %7.2f\n", m->vertex_count,
           with_hinges ? "yes" : "no", s.A.block_count, megabytes(&s.A), 1e6 * half,
           full.block_count, megabytes(&full), 1e6 * whole, whole / half);
    status = 0;
done:
    free(x);
    free(y);
    free(z);
    free(seconds);
    block_matrix_free(&full);
    system_free(&s);
    return status;
}

static int measure_mesh(int vertices, int boundary, int repeats) {
    char error[256] = "out of memory";
    mesh m;
    int non_manifold, status = -1;
    if (mesh_generate(&m, vertices, boundary, 1, 1, error) != 0) {
        fprintf(stderr, "product: %s\n", error);
        return -1;
    }
    if (mesh_connect(&m, &non_manifold, error) == 0 &&
        mesh_reorder(&m, MESH_ORDER_SORTED, 1, NULL, error) == 0 && measure(&m, 0, repeats) == 0 &&
        measure(&m, 1, repeats) == 0)
        status = 0;
    else
        fprintf(stderr, "product: %s\n", error);
    mesh_free(&m);
    return status;
}

int main(int argc, char **argv) {
    if (argc < 4 || argc % 3 != 1) {
        fprintf(stderr, "usage: %s VERTICES BOUNDARY REPEATS [VERTICES BOUNDARY REPEATS]...\n",
                argv[0]);
        return 2;
    }
    printf("%8s %-9s %9s %8s %10s %9s %8s %10s %7s\n", "vertices", "bending", "half", "MB", "us",
           "full", "MB", "us", "gain");
    for (int k = 1; k < argc; k += 3) {
        const int repeats = atoi(argv[k + 2]);
        if (measure_mesh(atoi(argv[k]), atoi(argv[k + 1]), repeats > 0 ? repeats : 1) != 0)
            return 1;
    }
    return 0;
}
