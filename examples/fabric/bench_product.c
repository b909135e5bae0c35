/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Half or whole? The time of a product with the cloth's matrix when half of it is stored, against
 * every block, on the paper's two meshes (or: bench_product VERTICES BOUNDARY REPEATS).
 */
#include <stdio.h>
#include <stdlib.h>

#include "clock.h"
#include "mesh.h"
#include "sparse_product.h"

typedef void product(const block_matrix *A, const double (*x)[3], double (*y)[3]);

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The median time of one product, s. Includes setting y to 0, which half_product needs. */
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

/* Measures one matrix, with or without hinges; 0, or -1 without memory. */
static int measure(const mesh *m, int with_hinges, int repeats) {
    const element_list lists[2] = {{m->triangle_count, 3, &m->triangle[0][0]},
                                   {m->hinge_count, 4, &m->hinge[0][0]}};
    linear_system s = {0};
    block_matrix full = {0};
    const size_t n = (size_t)m->vertex_count;
    double(*x)[3] = calloc(n, sizeof *x);
    double(*y)[3] = calloc(n, sizeof *y);
    double *seconds = calloc((size_t)repeats, sizeof *seconds);
    int status = -1;
    if (!x || !y || !seconds || system_init(&s, m->vertex_count, with_hinges ? 2 : 1, lists) != 0)
        goto done;
    fill(&s.A);
    if (block_matrix_complete(&s.A, &full) != 0)
        goto done;
    for (size_t i = 0; i < n; i++)
        x[i][0] = x[i][1] = x[i][2] = 1.0 + (double)(i % 5);
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
        fprintf(stderr, "bench_product: %s\n", error);
        return -1;
    }
    if (mesh_connect(&m, &non_manifold, error) == 0 &&
        mesh_reorder(&m, MESH_ORDER_SORTED, 1, NULL, error) == 0 && measure(&m, 0, repeats) == 0 &&
        measure(&m, 1, repeats) == 0)
        status = 0;
    else
        fprintf(stderr, "bench_product: %s\n", error);
    mesh_free(&m);
    return status;
}

int main(int argc, char **argv) {
    if (argc != 1 && argc != 4) {
        fprintf(stderr, "usage: %s [VERTICES BOUNDARY REPEATS]\n", argv[0]);
        return 2;
    }
    printf("%8s %-9s %9s %8s %10s %9s %8s %10s %7s\n", "vertices", "bending", "half", "MB", "us",
           "full", "MB", "us", "gain");
    if (argc == 4)
        return measure_mesh(atoi(argv[1]), atoi(argv[2]), atoi(argv[3]) > 0 ? atoi(argv[3]) : 1) !=
               0;
    return measure_mesh(2602, 220, 1001) != 0 || measure_mesh(218272, 1713, 31) != 0;
}
