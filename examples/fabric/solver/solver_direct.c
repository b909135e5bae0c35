/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "solver_direct.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef FABRIC_WITH_CHOLMOD

#include <math.h>
#include <suitesparse/cholmod.h>

#include "solver_parts.h"

/* Present if the BLAS is OpenBLAS. Its threads cost more than they gain on these frontal matrices,
 * and their number would change bits. */
extern void openblas_set_num_threads(int count) __attribute__((weak));

struct direct_solver {
    cholmod_common common;
    cholmod_sparse *matrix; /* lower triangle by columns, which are the rows of A's upper half */
    cholmod_factor *factor;
    cholmod_dense *right;
};

int direct_solver_available(void) {
    return 1;
}

/* Row i's blocks become columns 3i to 3i + 2, since A is symmetric. Only the lower half of a
 * diagonal block is stored. */
static void lay_out(const block_matrix *A, cholmod_sparse *to) {
    int *start = to->p, *row = to->i;
    int next = 0;
    for (int i = 0; i < A->row_count; i++)
        for (int c = 0; c < 3; c++) {
            start[3 * i + c] = next;
            for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
                for (int r = A->column[k] == i ? c : 0; r < 3; r++)
                    row[next++] = 3 * A->column[k] + r;
        }
    start[3 * A->row_count] = next;
    assert((size_t)next == to->nzmax);
}

direct_solver *direct_solver_new(const block_matrix *A, char *error) {
    const size_t n = 3 * (size_t)A->row_count;
    const size_t entries = 9 * (size_t)A->block_count - n;
    direct_solver *d = calloc(1, sizeof *d);
    if (d) {
        if (openblas_set_num_threads)
            openblas_set_num_threads(1);
        cholmod_start(&d->common);
        d->common.print = 0;
        d->common.final_ll = 1; /* LL', not LDL', so that it stops at a negative pivot */
        d->matrix = cholmod_allocate_sparse(n, n, entries, 1, 1, -1, CHOLMOD_REAL, &d->common);
        d->right = cholmod_allocate_dense(n, 1, n, CHOLMOD_REAL, &d->common);
        if (d->matrix && d->right) {
            lay_out(A, d->matrix);
            d->factor = cholmod_analyze(d->matrix, &d->common);
        }
        if (d->factor)
            return d;
    }
    direct_solver_free(d);
    snprintf(error, 256, "out of memory for the direct solution");
    return NULL;
}

void direct_solver_free(direct_solver *d) {
    if (!d)
        return;
    cholmod_free_factor(&d->factor, &d->common);
    cholmod_free_sparse(&d->matrix, &d->common);
    cholmod_free_dense(&d->right, &d->common);
    cholmod_finish(&d->common);
    free(d);
}

double direct_solver_work(const direct_solver *d) {
    return d->common.fl / 2 + 2 * d->common.lnz;
}

void direct_solver_memory(const direct_solver *d, double *held, double *more) {
    const cholmod_factor *L = d->factor;
    const double entries = (double)d->matrix->nzmax, n = (double)L->n;
    /* cholmod_factorize makes two copies: the permuted matrix, and an intermediate transpose. */
    const double copies = 2 * entries * (sizeof(double) + sizeof(int)) + 8 * n * sizeof(double);
    const double factor = L->is_super ? ((double)L->xsize + (double)L->maxcsize) * sizeof(double)
                                      : d->common.lnz * (sizeof(double) + sizeof(int));
    *held = (double)d->common.memory_inuse;
    *more = factor + copies;
}

/* Returns entry (r, c) of S_i A_ij S_j + s (I - S_i) with A_ij = block k. The second term occurs
 * only on the diagonal. */
static double entry(const block_matrix *A, const constraints *given, int i, int k, int r, int c) {
    const int j = A->column[k];
    const double(*a)[3] = (const double(*)[3])A->value[k];
    if (given->given[i] == 0 && given->given[j] == 0)
        return a[r][c];
    const double(*Si)[3] = constraint_projection(given, i),
          (*Sj)[3] = constraint_projection(given, j);
    double sum = i == j ? a[0][0] * ((r == c ? 1 : 0) - Si[r][c]) : 0;
    for (int p = 0; p < 3; p++)
        for (int q = 0; q < 3; q++)
            sum += Si[r][p] * a[p][q] * Sj[q][c];
    return sum;
}

/* Element (row, column) of the lower triangle is (column, row) of A's stored half. */
static void fill(direct_solver *d, const block_matrix *A, const constraints *given) {
    double *value = d->matrix->x;
    int next = 0;
    for (int i = 0; i < A->row_count; i++)
        for (int c = 0; c < 3; c++)
            for (int k = A->row_start[i]; k < A->row_start[i + 1]; k++)
                for (int r = A->column[k] == i ? c : 0; r < 3; r++)
                    value[next++] = entry(A, given, i, k, c, r);
    assert((size_t)next == d->matrix->nzmax);
}

solver_status direct_solver_solve(direct_solver *d, solver *s, const linear_system *system,
                                  const constraints *c, double (*dv)[3], long *iterations) {
    double *right = d->right->x;
    solver_apply(c, dv);
    solver_impulses(s, system, (const double(*)[3])dv);
    solver_filter(c, s->residual);
    for (int i = 0; i < 3 * s->count; i++) {
        right[i] = s->residual[i / 3][i % 3];
        if (!isfinite(right[i]))
            return SOLVER_NOT_FINITE;
    }
    fill(d, &system->A, c);
    ++*iterations;
    cholmod_factorize(d->matrix, d->factor, &d->common);
    if (d->common.status == CHOLMOD_NOT_POSDEF)
        return SOLVER_BREAKDOWN;
    cholmod_dense *found = d->common.status == CHOLMOD_OK
                               ? cholmod_solve(CHOLMOD_A, d->factor, d->right, &d->common)
                               : NULL;
    if (!found)
        return SOLVER_NOT_FINITE; /* out of memory */
    const double *change = found->x;
    int broken = 0;
    for (int i = 0; i < 3 * s->count; i++) {
        dv[i / 3][i % 3] += change[i];
        broken |= !isfinite(change[i]);
    }
    cholmod_free_dense(&found, &d->common);
    solver_apply(c, dv);
    return broken ? SOLVER_NOT_FINITE : SOLVER_CONVERGED;
}

#else

int direct_solver_available(void) {
    return 0;
}

direct_solver *direct_solver_new(const block_matrix *A, char *error) {
    (void)A;
    snprintf(error, 256,
             "solution.method is 'direct', which this program was built without: it needs CHOLMOD "
             "(libsuitesparse-dev)");
    return NULL;
}

void direct_solver_free(direct_solver *d) {
    (void)d;
}

double direct_solver_work(const direct_solver *d) {
    (void)d;
    return 0;
}

void direct_solver_memory(const direct_solver *d, double *held, double *more) {
    (void)d;
    *held = *more = 0;
}

solver_status direct_solver_solve(direct_solver *d, solver *s, const linear_system *system,
                                  const constraints *c, double (*dv)[3], long *iterations) {
    (void)d, (void)s, (void)system, (void)c, (void)dv, (void)iterations;
    return SOLVER_BREAKDOWN;
}

#endif
