/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * With C C' the relaxed diagonal blocks of the prefiltered matrix, the scaled matrix is
 *     A^ = C^-1 A C^-T = D^ + U + U' + E + E'
 * Vertices are taken in another order, all even domains before all odd ones. U are the blocks above
 * the diagonal in that order, but for those between domains of the same kind, E, of which there are
 * few: where neighbours have near numbers a domain touches those before and after it. So domains
 * of a kind are swept at the same time. The preconditioner is (I + U)' (I + U), and the iteration
 * runs on (I + U)^-T A^ (I + U)^-1. With t = (I + U)^-1 p the image of p is (Eisenstat 1981)
 *     t + (I + U)^-T w,    w = p + (D^ - 2 I + E + E') t
 * so that each block of A is used twice an iteration, as in a product of the symmetric half.
 */
#include "solver_domains.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "matrix3.h"
#include "solver_factor.h"
#include "solver_parts.h"
#include "solver_precondition.h"
#include "sparse_product.h"
#include "vector.h"

/* A block of `across` as its column sees it. */
typedef struct reached {
    int row, block;
} reached;

struct domain_solver {
    const block_matrix *A;
    int count;               /* domains */
    int *start;              /* [count + 1] a domain's first vertex */
    int *domain;             /* [rows] a vertex' domain */
    int *place;              /* [A's blocks] where in the matrix that it belongs to */
    block_matrix within;     /* of U, within domains */
    block_matrix across;     /* of U, from even domains' vertices to odd ones' */
    int *reached_start;      /* [rows + 1] where in `reached` a column of `across` begins */
    reached *reached;        /* [across' blocks] column by column, each from its first row on */
    block_matrix between;    /* E, and D^ - 2 I as its diagonal */
    double (*root)[3][3];    /* [rows] C^-1, lower triangles */
    double (*direction)[3];  /* p */
    double (*residual)[3];   /* of the transformed system */
    double (*correction)[3]; /* its solution */
    double (*swept)[3];      /* t */
    double (*image)[3];      /* w, then (I + U)^-T w */
    double *sum_direction, *sum_residual; /* [count] partial sums of p . image and r . r */
};

/* Part of the result's bits, so not to be tuned by machine. A sorted mesh of n vertices has a
 * bandwidth in proportion to sqrt(n), with bending some 3 sqrt(n); a domain is to be longer. */
static int domain_count(int vertices) {
    return 2 * (1 + (int)(sqrt((double)vertices) / 14));
}

static int is_odd(const domain_solver *d, int vertex) {
    return d->domain[vertex] % 2;
}

/* What a block of A belongs to. One from an odd domain to an even one is transposed there. */
static block_matrix *home_of(domain_solver *d, int row, int column) {
    if (row != column && d->domain[row] == d->domain[column])
        return &d->within;
    return is_odd(d, row) == is_odd(d, column) ? &d->between : &d->across;
}

static int is_transposed(const domain_solver *d, int row, int column) {
    return is_odd(d, row) && !is_odd(d, column);
}

/* Lays out one of the matrices: which of A's blocks go there, and where. 0, or -1. */
static int lay_out(domain_solver *d, block_matrix *m) {
    const block_matrix *A = d->A;
    const size_t rows = (size_t)A->row_count;
    m->row_count = A->row_count;
    m->row_start = calloc(rows + 2, sizeof *m->row_start);
    if (!m->row_start)
        return -1;
    /* Counted one row late, so that filling in makes the starts right. */
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

/* The columns of `across`, for sweeps of odd domains. 0, or -1. */
static int lay_out_columns(domain_solver *d) {
    const block_matrix *m = &d->across;
    d->reached_start = calloc((size_t)m->row_count + 2, sizeof *d->reached_start);
    d->reached = calloc((size_t)m->block_count + 1, sizeof *d->reached);
    if (!d->reached_start || !d->reached)
        return -1;
    for (int k = 0; k < m->block_count; k++)
        d->reached_start[m->column[k] + 2]++;
    for (int j = 2; j < m->row_count + 2; j++)
        d->reached_start[j] += d->reached_start[j - 1];
    for (int i = 0; i < m->row_count; i++)
        for (int k = m->row_start[i]; k < m->row_start[i + 1]; k++)
            d->reached[d->reached_start[m->column[k] + 1]++] = (reached){i, k};
    return 0;
}

static int allocate(domain_solver *d) {
    const size_t rows = (size_t)d->A->row_count + 1;
    double(**vectors[])[3] = {&d->direction, &d->residual, &d->correction, &d->swept, &d->image};
    d->start = calloc((size_t)d->count + 1, sizeof *d->start);
    d->domain = calloc(rows, sizeof *d->domain);
    d->place = calloc((size_t)d->A->block_count + 1, sizeof *d->place);
    d->root = calloc(rows, sizeof *d->root);
    d->sum_direction = calloc((size_t)d->count, sizeof *d->sum_direction);
    d->sum_residual = calloc((size_t)d->count, sizeof *d->sum_residual);
    for (size_t k = 0; k < sizeof vectors / sizeof *vectors; k++)
        if (!(*vectors[k] = calloc(rows, sizeof(double[3]))))
            return -1;
    return d->start && d->domain && d->place && d->root && d->sum_direction && d->sum_residual ? 0
                                                                                               : -1;
}

static void divide(domain_solver *d) {
    for (int k = 0; k < d->count; k++) {
        d->start[k + 1] = (int)((long long)d->A->row_count * (k + 1) / d->count);
        for (int i = d->start[k]; i < d->start[k + 1]; i++)
            d->domain[i] = k;
    }
}

domain_solver *domain_solver_new(const block_matrix *A) {
    domain_solver *d = calloc(1, sizeof *d);
    if (!d)
        return NULL;
    d->A = A;
    d->count = domain_count(A->row_count);
    if (allocate(d) == 0) {
        divide(d);
        if (lay_out(d, &d->within) == 0 && lay_out(d, &d->across) == 0 &&
            lay_out(d, &d->between) == 0 && lay_out_columns(d) == 0)
            return d;
    }
    domain_solver_free(d);
    return NULL;
}

void domain_solver_free(domain_solver *d) {
    if (!d)
        return;
    free(d->start);
    free(d->domain);
    free(d->place);
    block_matrix_free(&d->within);
    block_matrix_free(&d->across);
    block_matrix_free(&d->between);
    free(d->reached_start);
    free(d->reached);
    free(d->root);
    free(d->direction);
    free(d->residual);
    free(d->correction);
    free(d->swept);
    free(d->image);
    free(d->sum_direction);
    free(d->sum_residual);
    free(d);
}

/* out = left block right', left and right lower triangles */
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

/* Block k, of row i, filtered and scaled. */
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

static void build(domain_solver *d, const constraints *c) {
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

/* t -= the row of U times x */
static inline void subtract_row(const block_matrix *U, int row, const double (*x)[3], double t[3]) {
    double t0 = t[0], t1 = t[1], t2 = t[2];
    for (int k = U->row_start[row]; k < U->row_start[row + 1]; k++) {
        const double *y = x[U->column[k]];
        const double(*u)[3] = (const double(*)[3])U->value[k];
        t0 -= u[0][0] * y[0] + u[0][1] * y[1] + u[0][2] * y[2];
        t1 -= u[1][0] * y[0] + u[1][1] * y[1] + u[1][2] * y[2];
        t2 -= u[2][0] * y[0] + u[2][1] * y[1] + u[2][2] * y[2];
    }
    t[0] = t0;
    t[1] = t1;
    t[2] = t2;
}

/* to = (I + U)^-1 from in one domain, row by row from the last; all odd domains before an even one.
 * to may be from. */
static void sweep_up(const domain_solver *d, int domain, const double (*from)[3], double (*to)[3]) {
    for (int i = d->start[domain + 1] - 1; i >= d->start[domain]; i--) {
        double t[3] = {from[i][0], from[i][1], from[i][2]};
        subtract_row(&d->across, i, (const double(*)[3])to, t); /* of an odd domain: empty */
        subtract_row(&d->within, i, (const double(*)[3])to, t);
        for (int a = 0; a < 3; a++)
            to[i][a] = t[a];
    }
}

/* r -= the column of `across` times r, of even domains swept before. */
static void subtract_column(const domain_solver *d, int column, double (*r)[3]) {
    double t0 = 0, t1 = 0, t2 = 0;
    for (int k = d->reached_start[column]; k < d->reached_start[column + 1]; k++) {
        const double *w = r[d->reached[k].row];
        const double(*u)[3] = (const double(*)[3])d->across.value[d->reached[k].block];
        t0 -= u[0][0] * w[0] + u[1][0] * w[1] + u[2][0] * w[2];
        t1 -= u[0][1] * w[0] + u[1][1] * w[1] + u[2][1] * w[2];
        t2 -= u[0][2] * w[0] + u[1][2] * w[1] + u[2][2] * w[2];
    }
    r[column][0] += t0;
    r[column][1] += t1;
    r[column][2] += t2;
}

/* r = (I + U)^-T r in one domain, in place; all even domains before an odd one. */
static void sweep_down(const domain_solver *d, int domain, double (*r)[3]) {
    const block_matrix *U = &d->within;
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++) {
        subtract_column(d, i, r); /* of an even domain: empty */
        for (int k = U->row_start[i]; k < U->row_start[i + 1]; k++) {
            /* Read here, not once a row: a row by itself is too short to be a loop for threads. */
            const double w0 = r[i][0], w1 = r[i][1], w2 = r[i][2];
            double *y = r[U->column[k]];
            const double(*u)[3] = (const double(*)[3])U->value[k];
            y[0] -= u[0][0] * w0 + u[1][0] * w1 + u[2][0] * w2;
            y[1] -= u[0][1] * w0 + u[1][1] * w1 + u[2][1] * w2;
            y[2] -= u[0][2] * w0 + u[1][2] * w1 + u[2][2] * w2;
        }
    }
}

/* residual = C^-1 r */
static void scale_residual(domain_solver *d, const double (*r)[3]) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < d->A->row_count; i++) {
        const double(*root)[3] = (const double(*)[3])d->root[i];
        d->residual[i][0] = root[0][0] * r[i][0];
        d->residual[i][1] = root[1][0] * r[i][0] + root[1][1] * r[i][1];
        d->residual[i][2] = root[2][0] * r[i][0] + root[2][1] * r[i][1] + root[2][2] * r[i][2];
    }
}

/* The first half of r = (I + U)^-T r: what is left are the odd domains. */
static void sweep_even_down(domain_solver *d, double (*r)[3]) {
#pragma omp parallel for schedule(static)
    for (int domain = 0; domain < d->count; domain += 2)
        sweep_down(d, domain, r);
}

/* residual = the transformed r; returns its square, r' M^-1 r. */
static double transform(domain_solver *d, const double (*r)[3]) {
    scale_residual(d, r);
    sweep_even_down(d, d->residual);
#pragma omp parallel for schedule(static)
    for (int domain = 0; domain < d->count; domain++) {
        double sum = 0;
        if (domain % 2)
            sweep_down(d, domain, d->residual);
        for (int i = d->start[domain]; i < d->start[domain + 1]; i++)
            sum += vector_dot(d->residual[i], d->residual[i]);
        d->sum_residual[domain] = sum;
    }
    return solver_sum(d->sum_residual, d->count);
}

/* dv += what the correction is in the system's own terms. */
static void add_correction(domain_solver *d, double (*dv)[3]) {
#pragma omp parallel
    {
        for (int odd = 1; odd >= 0; odd--) {
#pragma omp for schedule(static)
            for (int domain = odd; domain < d->count; domain += 2)
                sweep_up(d, domain, (const double(*)[3])d->correction, d->correction);
        }
#pragma omp for schedule(static)
        for (int i = 0; i < d->A->row_count; i++) {
            const double(*root)[3] = (const double(*)[3])d->root[i];
            const double *y = d->correction[i];
            dv[i][0] += root[0][0] * y[0] + root[1][0] * y[1] + root[2][0] * y[2];
            dv[i][1] += root[1][1] * y[1] + root[2][1] * y[2];
            dv[i][2] += root[2][2] * y[2];
        }
    }
}

static int has_between(const domain_solver *d) {
    return d->between.block_count > d->A->row_count; /* the diagonal is there in any case */
}

/* What an iteration begins with: t, and w but for its product with what is between domains, which
 * is to add the diagonal's part as well. Where nothing is between, w is whole, and an even domain
 * is swept down at once. */
static void sweep_direction(domain_solver *d, int domain) {
    const int whole = !has_between(d);
    sweep_up(d, domain, (const double(*)[3])d->direction, d->swept);
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++)
        for (int a = 0; a < 3; a++)
            d->image[i][a] =
                d->direction[i][a] + (whole ? vector_dot(d->between.value[i][a], d->swept[i]) : 0);
    if (whole && domain % 2 == 0)
        sweep_down(d, domain, d->image);
}

/* correction = 0, p = the residual, and what an iteration begins with. */
static void begin(domain_solver *d) {
    const size_t size = sizeof(double[3]) * (size_t)d->A->row_count;
    memset(d->correction, 0, size);
    memcpy(d->direction, d->residual, size);
#pragma omp parallel
    for (int odd = 1; odd >= 0; odd--) {
#pragma omp for schedule(static)
        for (int domain = odd; domain < d->count; domain += 2)
            sweep_direction(d, domain);
    }
}

/* The image of p at vertex i: t + (I + U)^-T w. Not kept: while odd domains are swept down, even
 * ones' w is read. */
static inline void image_at(const domain_solver *d, int i, double image[3]) {
    vector_add_scaled(d->image[i], 1, d->swept[i], image);
}

/* Sweeps the rest down; returns p . image of one domain. */
static double finish_image(domain_solver *d, int domain) {
    double sum = 0;
    if (domain % 2)
        sweep_down(d, domain, d->image);
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++) {
        double image[3];
        image_at(d, i, image);
        sum += vector_dot(d->direction[i], image);
    }
    return sum;
}

/* correction += alpha p, residual -= alpha image; returns the residual's square in one domain. */
static double advance(domain_solver *d, int domain, double alpha) {
    double sum = 0;
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++) {
        double image[3];
        image_at(d, i, image);
        vector_add_scaled(d->correction[i], alpha, d->direction[i], d->correction[i]);
        vector_add_scaled(d->residual[i], -alpha, image, d->residual[i]);
        sum += vector_dot(d->residual[i], d->residual[i]);
    }
    return sum;
}

/* p = residual + beta p */
static void turn(domain_solver *d, int domain, double beta) {
    for (int i = d->start[domain]; i < d->start[domain + 1]; i++)
        vector_add_scaled(d->residual[i], beta, d->direction[i], d->direction[i]);
}

/* All of an iteration but the product. *square = r . r, before and after; returns p . image. One
 * that is not positive changes nothing but the direction. Every thread sums the domains' sums
 * itself. */
static double finish_iteration(domain_solver *d, double *square) {
    const double before = *square;
#pragma omp parallel
    {
        double curvature, after;
#pragma omp for schedule(static)
        for (int domain = 0; domain < d->count; domain++)
            d->sum_direction[domain] = finish_image(d, domain);
        curvature = solver_sum(d->sum_direction, d->count);
#pragma omp for schedule(static)
        for (int domain = 0; domain < d->count; domain++)
            d->sum_residual[domain] = advance(d, domain, curvature > 0 ? before / curvature : 0);
        after = solver_sum(d->sum_residual, d->count);
        for (int odd = 1; odd >= 0; odd--) {
#pragma omp for schedule(static)
            for (int domain = odd; domain < d->count; domain += 2) {
                turn(d, domain, after / before);
                sweep_direction(d, domain);
            }
        }
    }
    *square = solver_sum(d->sum_residual, d->count);
    return solver_sum(d->sum_direction, d->count);
}

/* From the residual that transform left, of square `square`, to one of square `goal`. */
static solver_status iterate(domain_solver *d, double square, double goal, long most,
                             long *iterations) {
    begin(d);
    for (long k = 0;; k++) {
        if (!isfinite(square))
            return SOLVER_NOT_FINITE;
        if (square <= goal)
            return SOLVER_CONVERGED;
        if (k == most)
            return SOLVER_TOO_MANY_ITERATIONS;
        if (has_between(d)) {
            half_product(&d->between, (const double(*)[3])d->swept, d->image);
            sweep_even_down(d, d->image);
        }
        ++*iterations;
        const double curvature = finish_iteration(d, &square);
        if (!isfinite(curvature))
            return SOLVER_NOT_FINITE;
        if (!(curvature > 0))
            return SOLVER_BREAKDOWN;
    }
}

solver_status domain_solver_solve(domain_solver *d, solver *s, const linear_system *system,
                                  const constraints *c, const solver_limits *limits,
                                  double (*dv)[3], long *iterations) {
    build(d, c);
    solver_reference_residual(s, system, c, solver_apply(c, dv));
    const double reference = transform(d, (const double(*)[3])s->residual);
    if (!isfinite(reference))
        return SOLVER_NOT_FINITE;
    solver_residual(s, system, c, (const double(*)[3])dv);
    const double square = transform(d, (const double(*)[3])s->residual);
    const solver_status status =
        iterate(d, square, solver_goal(limits, reference), limits->max_iterations, iterations);
    if (status != SOLVER_NOT_FINITE)
        add_correction(d, dv);
    solver_apply(c, dv); /* rounding puts a little of the correction along given directions */
    return status;
}
