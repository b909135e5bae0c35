/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The division of the matrix among the domains, and the domains' values. */
#include "solver_domains_parts.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver_factor.h"
#include "solver_precondition.h"

/* The number of domains determines the result's bits, so it must not be tuned by machine. A sorted
 * mesh of n vertices has a bandwidth proportional to sqrt(n), with bending about 3 sqrt(n). A
 * domain should be longer than that. */
int domain_count(int vertices) {
    return 2 * (1 + (int)(sqrt((double)vertices) / 14));
}

int domain_start(int vertices, int domain) {
    assert(domain >= 0 && domain <= domain_count(vertices));
    return (int)((long long)vertices * domain / domain_count(vertices));
}

static int is_odd(const domain_solver *d, int vertex) {
    return d->domain[vertex] % 2;
}

/* Returns the matrix to which a block of A belongs. Blocks from odd to even domains are stored
 * transposed. */
static block_matrix *home_of(domain_solver *d, int row, int column) {
    if (row != column && d->domain[row] == d->domain[column])
        return &d->within;
    return is_odd(d, row) == is_odd(d, column) ? &d->between : &d->across;
}

static int is_transposed(const domain_solver *d, int row, int column) {
    return is_odd(d, row) && !is_odd(d, column);
}

/* Lays out one of the three matrices: finds A's blocks that belong to it, and their indices.
 * Returns 0, or -1 if out of memory. */
static int lay_out(domain_solver *d, block_matrix *m) {
    const block_matrix *A = d->A;
    const size_t rows = (size_t)A->row_count;
    m->row_count = A->row_count;
    m->row_start = calloc(rows + 2, sizeof *m->row_start);
    if (!m->row_start)
        return -1;
    /* Row i is counted at i + 2, so that the filling below advances row_start[i + 1] to row i's
     * end. */
    for (int i = 0; i < A->row_count; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
            if (home_of(d, i, A->column[k]) == m)
                m->row_start[(is_transposed(d, i, A->column[k]) ? A->column[k] : i) + 2]++;
    for (size_t i = 2; i < rows + 2; i++)
        m->row_start[i] += m->row_start[i - 1];
    m->block_count = m->row_start[rows + 1];
    m->column = calloc((size_t)m->block_count + 1, sizeof *m->column);
    m->value = calloc((size_t)m->block_count + 1, sizeof *m->value);
    if (!m->column || !m->value)
        return -1;
    for (int i = 0; i < A->row_count; i++)
        for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++) {
            const int j = A->column[k], transposed = is_transposed(d, i, j);
            if (home_of(d, i, j) != m)
                continue;
            d->place[k] = m->row_start[(transposed ? j : i) + 1]++;
            m->column[d->place[k]] = transposed ? i : j;
        }
    return 0;
}

/* Lists the blocks of `across` by columns, for sweeps of odd domains. Returns 0, or -1 if out of
 * memory. */
static int lay_out_columns(domain_solver *d) {
    const block_matrix *m = &d->across;
    int *start = arrays_add(&d->own, (size_t)m->row_count + 2, sizeof *start);
    reached *entry = arrays_add(&d->own, (size_t)m->block_count + 1, sizeof *entry);
    d->columns = (reached_columns){start, entry};
    if (d->own.failed)
        return -1;
    for (int k = 0; k < m->block_count; k++)
        start[m->column[k] + 2]++;
    for (int j = 2; j < m->row_count + 2; j++)
        start[j] += start[j - 1];
    for (int i = 0; i < m->row_count; i++)
        for (int k = m->row_start[i]; k < m->row_start[i + 1]; k++)
            entry[start[m->column[k] + 1]++] = (reached){i, k};
    return 0;
}

/* Sets each domain's neighbours: the domains of the other parity with which it shares blocks. */
static void find_neighbours(domain_solver *d) {
    const block_matrix *m = &d->across;
    for (int i = 0; i < m->row_count; i++)
        for (int k = m->row_start[i]; k < m->row_start[i + 1]; k++) {
            const int even = d->domain[i], odd = d->domain[m->column[k]];
            domain_turn_add_neighbour(&d->turn[even], odd);
            domain_turn_add_neighbour(&d->turn[odd], even);
        }
}

static int allocate(domain_solver *d) {
    const size_t rows = (size_t)d->A->row_count + 1;
    double(**vectors[])[3] = {&d->direction, &d->residual, &d->correction, &d->swept, &d->image};
    d->start = arrays_add(&d->own, (size_t)d->count + 1, sizeof *d->start);
    d->domain = arrays_add(&d->own, rows, sizeof *d->domain);
    d->turn = arrays_add(&d->own, (size_t)d->count + 1, sizeof *d->turn);
    d->place = arrays_add(&d->own, (size_t)d->A->block_count + 1, sizeof *d->place);
    d->root = arrays_add(&d->own, rows, sizeof *d->root);
    d->sum_direction = arrays_add(&d->own, (size_t)d->count, sizeof *d->sum_direction);
    d->sum_residual = arrays_add(&d->own, (size_t)d->count, sizeof *d->sum_residual);
    for (size_t k = 0; k < sizeof vectors / sizeof *vectors; k++)
        *vectors[k] = arrays_add(&d->own, rows, sizeof(double[3]));
    return d->own.failed ? -1 : 0;
}

domain_solver *domain_solver_divided(const block_matrix *A, int count, const int *start) {
    domain_solver *d = calloc(1, sizeof *d);
    if (!d)
        return NULL;
    d->A = A;
    d->count = count;
    if (allocate(d) == 0) {
        memcpy(d->start, start, ((size_t)count + 1) * sizeof *start);
        for (int k = 0; k < count; k++)
            for (int i = start[k]; i < start[k + 1]; i++)
                d->domain[i] = k;
        if (lay_out(d, &d->within) == 0 && lay_out(d, &d->across) == 0 &&
            lay_out(d, &d->between) == 0 && lay_out_columns(d) == 0) {
            assert(d->within.block_count + d->across.block_count + d->between.block_count ==
                   A->block_count);
            /* `between` always has a diagonal. */
            d->has_between = d->between.block_count > A->row_count;
            find_neighbours(d);
            return d;
        }
    }
    domain_solver_free(d);
    return NULL;
}

domain_solver *domain_solver_new(const block_matrix *A) {
    const int count = domain_count(A->row_count);
    int *start = malloc(((size_t)count + 1) * sizeof *start);
    domain_solver *d = NULL;
    for (int k = 0; start && k <= count; k++)
        start[k] = domain_start(A->row_count, k);
    if (start)
        d = domain_solver_divided(A, count, start);
    free(start);
    return d;
}

void domain_solver_free(domain_solver *d) {
    if (!d)
        return;
    block_matrix_free(&d->within);
    block_matrix_free(&d->across);
    block_matrix_free(&d->between);
    arrays_free(&d->own);
    free(d);
}

/* out = left block right', for lower triangles left and right */
static void scale(const double left[3][3], const double block[3][3], const double right[3][3],
                  double out[3][3]) {
    double half[3][3];
    for (int c = 0; c < 3; c++) {
        half[0][c] = left[0][0] * block[0][c];
        half[1][c] = left[1][0] * block[0][c] + left[1][1] * block[1][c];
        half[2][c] = left[2][0] * block[0][c] + left[2][1] * block[1][c] + left[2][2] * block[2][c];
    }
    for (int r = 0; r < 3; r++) {
        out[r][0] = half[r][0] * right[0][0];
        out[r][1] = half[r][0] * right[1][0] + half[r][1] * right[1][1];
        out[r][2] = half[r][0] * right[2][0] + half[r][1] * right[2][1] + half[r][2] * right[2][2];
    }
}

/* Filters and scales block k of row i of A, and stores it in its matrix. */
static void build_block(domain_solver *d, const constraints *c, int i, int k) {
    const int j = d->A->column[k];
    double block[3][3], out[3][3];
    double(*to)[3] = home_of(d, i, j)->value[d->place[k]];
    const int transposed = is_transposed(d, i, j);
    prefiltered_block(d->A, c, i, k, block);
    scale((const double(*)[3])d->root[i], (const double(*)[3])block, (const double(*)[3])d->root[j],
          out);
    for (int r = 0; r < 3; r++)
        for (int s = 0; s < 3; s++)
            to[r][s] = (transposed ? out[s][r] : out[r][s]) - (i == j && r == s ? 2 : 0);
}

void domain_build(domain_solver *d, const constraints *c) {
    const block_matrix *A = d->A;
#pragma omp parallel
    {
#pragma omp for schedule(static)
        for (int i = 0; i < A->row_count; i++) {
            double block[3][3];
            prefiltered_block(A, c, i, A->row_start[i], block);
            gauss_seidel_root((const double(*)[3])block, d->root[i]);
        }
#pragma omp for schedule(static)
        for (int i = 0; i < A->row_count; i++)
            for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
                build_block(d, c, i, k);
    }
}
