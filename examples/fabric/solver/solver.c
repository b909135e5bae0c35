/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Parallel conjugate gradients with block-Jacobi, and the choice among all methods. An iteration
 * has two parallel regions: the product A p, and everything else. The second makes three passes
 * over chunks of vertices. Every thread adds up the chunks' partial sums itself, in order, so that
 * all threads get the same step length without communication.
 */
#include "solver.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>

#include "base/vector.h"
#include "solver_direct.h"
#include "solver_parts.h"
#include "solver_precondition.h"

void solver_free(solver *s) {
    arrays_free(&s->own);
    arrays_free(&s->jacobi);
    packed_solver_free(s->packed);
    domain_solver_free(s->domains);
    direct_solver_free(s->direct);
    *s = (solver){0};
}

int solver_init(solver *s, int count) {
    const size_t n = (size_t)count + 1;
    *s = (solver){.count = count, .chunks = (count + SOLVER_CHUNK - 1) / SOLVER_CHUNK};
    s->options.preconditioner = PRECONDITIONER_BLOCK_JACOBI;
    s->residual = arrays_add(&s->own, n, sizeof *s->residual);
    s->product = arrays_add(&s->own, n, sizeof *s->product);
    s->preconditioned = arrays_add(&s->jacobi, n, sizeof *s->preconditioned);
    s->direction = arrays_add(&s->jacobi, n, sizeof *s->direction);
    s->inverse = arrays_add(&s->jacobi, n, sizeof *s->inverse);
    s->sum_direction = arrays_add(&s->jacobi, (size_t)s->chunks + 1, sizeof *s->sum_direction);
    s->sum_residual = arrays_add(&s->jacobi, (size_t)s->chunks + 1, sizeof *s->sum_residual);
    if (!s->own.failed && !s->jacobi.failed)
        return 0;
    solver_free(s);
    return -1;
}

/* Frees the arrays that only block-Jacobi and solver_defect use. */
static void drop_block_jacobi(solver *s) {
    if (s->options.needs_defect)
        return;
    arrays_free(&s->jacobi);
    s->direction = s->preconditioned = NULL;
    s->inverse = NULL;
    s->sum_direction = s->sum_residual = NULL;
}

int solver_choose(solver *s, const block_matrix *A, const solver_options *options, char *error) {
    assert(A->row_count == s->count);
    assert(!s->direct && !s->packed && !s->domains);
    s->options = *options;
    if (options->method == METHOD_DIRECT) {
        s->direct = direct_solver_new(A, error);
        drop_block_jacobi(s);
        return s->direct ? 0 : -1;
    }
    if (options->preconditioner == PRECONDITIONER_BLOCK_JACOBI &&
        options->precision == PRECISION_DOUBLE)
        return 0;
    if (options->preconditioner == PRECONDITIONER_GAUSS_SEIDEL &&
        options->precision == PRECISION_DOUBLE)
        s->domains = domain_solver_new(A);
    else
        s->packed = packed_solver_new(A, options);
    if (s->domains || s->packed) {
        drop_block_jacobi(s);
        return 0;
    }
    snprintf(error, 256, "out of memory for the preconditioner");
    return -1;
}

double solver_sum(const double *term, int count) {
    double sum = 0;
    for (int k = 0; k < count; k++)
        sum += term[k];
    return sum;
}

static int chunk_end(const solver *s, int chunk) {
    const int end = (chunk + 1) * SOLVER_CHUNK;
    return end < s->count ? end : s->count;
}

/* Sets residual r = S (b - product) and preconditioned = P r, and clears product. Returns r'Pr. */
static double start_residual(solver *s, const constraints *c, const double (*b)[3]) {
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < s->chunks; chunk++) {
        double sum = 0;
        for (int i = chunk * SOLVER_CHUNK; i < chunk_end(s, chunk); i++) {
            vector_subtract(b[i], s->product[i], s->residual[i]);
            constraint_filter(c, i, s->residual[i]);
            precondition(s->inverse[i], s->residual[i], s->preconditioned[i]);
            sum += vector_dot(s->residual[i], s->preconditioned[i]);
            for (int a = 0; a < 3; a++)
                s->product[i][a] = 0;
        }
        s->sum_residual[chunk] = sum;
    }
    return solver_sum(s->sum_residual, s->chunks);
}

void solver_filter(const constraints *c, double (*r)[3]) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < c->count; i++)
        constraint_filter(c, i, r[i]);
}

int solver_apply(const constraints *c, double (*dv)[3]) {
    int which = UNCONSTRAINED;
#pragma omp parallel for schedule(static) reduction(max : which)
    for (int i = 0; i < c->count; i++) {
        if (c->given[i] == 0)
            continue;
        constraint_filter(c, i, dv[i]);
        const double *z = constraint_at(c, i)->z;
        for (int a = 0; a < 3; a++) {
            dv[i][a] += z[a];
            which = z[a] != 0 ? DRIVEN : (which > CONSTRAINED ? which : CONSTRAINED);
        }
    }
    return which;
}

static void clear(double (*y)[3], int count) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < count; i++)
        y[i][0] = y[i][1] = y[i][2] = 0;
}

static void copy(const double (*from)[3], double (*to)[3], int count) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < count; i++)
        for (int c = 0; c < 3; c++)
            to[i][c] = from[i][c];
}

/* p'Ap of one chunk. */
static double direction_sum(const solver *s, int chunk) {
    double sum = 0;
    for (int i = chunk * SOLVER_CHUNK; i < chunk_end(s, chunk); i++)
        sum += vector_dot(s->direction[i], s->product[i]);
    return sum;
}

/* Updates one chunk: dv += alpha p and r -= alpha S A p; recomputes P r. Returns the chunk's part
 * of r'Pr. */
static double advance(solver *s, const constraints *c, int chunk, double alpha, double (*dv)[3]) {
    double sum = 0;
    for (int i = chunk * SOLVER_CHUNK; i < chunk_end(s, chunk); i++) {
        vector_add_scaled(dv[i], alpha, s->direction[i], dv[i]);
        constraint_filter(c, i, s->product[i]);
        vector_add_scaled(s->residual[i], -alpha, s->product[i], s->residual[i]);
        precondition(s->inverse[i], s->residual[i], s->preconditioned[i]);
        sum += vector_dot(s->residual[i], s->preconditioned[i]);
    }
    return sum;
}

/* Sets p = P r + beta p in one chunk, and product = 0 for the next iteration. */
static void update_direction(solver *s, int chunk, double beta) {
    for (int i = chunk * SOLVER_CHUNK; i < chunk_end(s, chunk); i++) {
        vector_add_scaled(s->preconditioned[i], beta, s->direction[i], s->direction[i]);
        for (int c = 0; c < 3; c++)
            s->product[i][c] = 0;
    }
}

/* Does all of an iteration except the product A p. *rz is r'Pr, which it updates. Returns p'Ap; if
 * that is not positive, dv and r do not change. */
static double iterate(solver *s, const constraints *c, double (*dv)[3], double *rz) {
    const double before = *rz;
#pragma omp parallel
    {
        double curvature, after;
#pragma omp for schedule(static)
        for (int chunk = 0; chunk < s->chunks; chunk++)
            s->sum_direction[chunk] = direction_sum(s, chunk);
        curvature = solver_sum(s->sum_direction, s->chunks);
#pragma omp for schedule(static)
        for (int chunk = 0; chunk < s->chunks; chunk++)
            s->sum_residual[chunk] =
                advance(s, c, chunk, curvature > 0 ? before / curvature : 0, dv);
        after = solver_sum(s->sum_residual, s->chunks);
#pragma omp for schedule(static)
        for (int chunk = 0; chunk < s->chunks; chunk++)
            update_direction(s, chunk, after / before);
    }
    *rz = solver_sum(s->sum_residual, s->chunks);
    return solver_sum(s->sum_direction, s->chunks);
}

/* Sets z to the changes of velocity that the constraints give. */
static void set_given_changes(const constraints *c, double (*z)[3]) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < c->count; i++)
        for (int a = 0; a < 3; a++)
            z[i][a] = constraint_change(c, i)[a];
}

/* Returns the square of |S (b - A z)| in the preconditioner's norm, to which the tolerance is
 * relative. */
static double reference_square(solver *s, const linear_system *system, const constraints *c,
                               int driven) {
    if (driven) {
        set_given_changes(c, s->residual);
        half_product(&system->A, (const double(*)[3])s->residual, s->product);
    }
    return start_residual(s, c, (const double(*)[3])system->b);
}

static solver_status iterate_to(double goal, solver *s, const linear_system *system,
                                const constraints *c, int max_iterations, double (*dv)[3],
                                double rz, long *iterations) {
    for (int k = 0;; k++) {
        if (!isfinite(rz))
            return SOLVER_NOT_FINITE;
        if (rz <= goal)
            return SOLVER_CONVERGED;
        if (k == max_iterations)
            return SOLVER_TOO_MANY_ITERATIONS;
        half_product(&system->A, (const double(*)[3])s->direction, s->product);
        ++*iterations;
        const double curvature = iterate(s, c, dv, &rz);
        if (!isfinite(curvature))
            return SOLVER_NOT_FINITE;
        if (!(curvature > 0))
            return SOLVER_BREAKDOWN;
    }
}

/* The iteration updates only S r: along given directions r may be larger by orders of magnitude,
 * and its rounding errors would dominate. So b - A dv is computed again here. */
void solver_impulses(solver *s, const linear_system *system, const double (*dv)[3]) {
    clear(s->product, s->count);
    half_product(&system->A, dv, s->product);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < s->count; i++)
        vector_subtract(system->b[i], s->product[i], s->residual[i]);
}

void solver_residual(solver *s, const linear_system *system, const constraints *c,
                     const double (*dv)[3]) {
    solver_impulses(s, system, dv);
    solver_filter(c, s->residual);
}

void solver_reference_residual(solver *s, const linear_system *system, const constraints *c,
                               int which) {
    if (which == DRIVEN) {
        set_given_changes(c, s->residual); /* z; solver_residual may overwrite it */
        solver_residual(s, system, c, (const double(*)[3])s->residual);
        return;
    }
    copy((const double(*)[3])system->b, s->residual, s->count); /* z is 0 */
    solver_filter(c, s->residual);
}

double solver_goal(const solver_limits *limits, double reference) {
    assert(limits->tolerance >= 0 && limits->floor >= 0);
    const double relative = limits->tolerance * limits->tolerance * reference;
    const double absolute = limits->floor * limits->floor;
    return relative > absolute ? relative : absolute;
}

double solver_defect(solver *s, const linear_system *system, const constraints *c, double (*dv)[3],
                     double *reference) {
    assert(s->inverse && s->sum_direction && s->sum_residual);
    preconditioner_build(&system->A, c, s->inverse);
    const int which = solver_apply(c, dv);
    clear(s->product, s->count);
    *reference = sqrt(reference_square(s, system, c, which == DRIVEN));
    half_product(&system->A, (const double(*)[3])dv, s->product);
    return sqrt(start_residual(s, c, (const double(*)[3])system->b));
}

static solver_status solve_block_jacobi(solver *s, const linear_system *system,
                                        const constraints *c, const solver_limits *limits,
                                        double (*dv)[3], long *iterations) {
    preconditioner_build(&system->A, c, s->inverse);
    const int which = solver_apply(c, dv);
    clear(s->product, s->count);
    const double reference = reference_square(s, system, c, which == DRIVEN);
    half_product(&system->A, (const double(*)[3])dv, s->product);
    const double rz = start_residual(s, c, (const double(*)[3])system->b);
    copy((const double(*)[3])s->preconditioned, s->direction, s->count);
    if (!isfinite(reference))
        return SOLVER_NOT_FINITE;

    const solver_status status = iterate_to(solver_goal(limits, reference), s, system, c,
                                            limits->max_iterations, dv, rz, iterations);
    if (which != UNCONSTRAINED && status != SOLVER_NOT_FINITE)
        solver_impulses(s, system, (const double(*)[3])dv);
    return status;
}

solver_status solver_solve(solver *s, const linear_system *system, const constraints *c,
                           const solver_limits *limits, double (*dv)[3], long *iterations) {
    assert((s->direct != NULL) + (s->packed != NULL) + (s->domains != NULL) <= 1);
    assert(system->A.row_count == s->count && c->count == s->count);
    if (!s->direct && !s->packed && !s->domains)
        return solve_block_jacobi(s, system, c, limits, dv, iterations);
    const solver_status status =
        s->direct    ? direct_solver_solve(s->direct, s, system, c, dv, iterations)
        : s->domains ? domain_solver_solve(s->domains, s, system, c, limits, dv, iterations)
                     : packed_solver_solve(s->packed, s, system, c, limits, dv, iterations);
    if (status != SOLVER_NOT_FINITE)
        solver_impulses(s, system, (const double(*)[3])dv);
    return status;
}
