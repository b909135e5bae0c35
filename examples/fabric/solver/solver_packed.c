/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solver_factor.h"
#include "solver_parts.h"

#define REAL double
#define PACKED(name) double_##name
#include "solver_packed_template.h"
#undef REAL
#undef PACKED
#define REAL float
#define PACKED(name) float_##name
#include "solver_packed_template.h"
#undef REAL
#undef PACKED

/* In mixed precision, a run of the iteration in float ends when the residual has decreased by this
 * factor. Beyond that, the computed residual differs from the true one. */
static const double float_gain = 1e-3;
enum { most_refinements = 20 }; /* maximum number of runs of the iteration in float per solution */

struct packed_solver {
    const block_matrix *A;
    solver_options options;
    factored built;
    double_system in_double;
    float_system in_float;
    float (*diagonal)[6]; /* the blocks of `built`, rounded to float */
    float (*upper)[3][3];
    float (*factor)[3][3];
    float (*root)[3][3];
    arrays own;
};

static void allocate_float(packed_solver *p) {
    assert(p->options.precision != PRECISION_DOUBLE);
    const size_t rows = (size_t)p->A->row_count + 1, blocks = (size_t)p->A->block_count + 1;
    p->diagonal = arrays_add(&p->own, rows, sizeof *p->diagonal);
    p->upper = arrays_add(&p->own, blocks, sizeof *p->upper);
    p->factor = p->built.factor ? arrays_add(&p->own, blocks, sizeof *p->factor) : NULL;
    p->root = arrays_add(&p->own, rows, sizeof *p->root);
    float_allocate(&p->in_float, p->A, &p->own);
    p->in_float.diagonal = (const float(*)[6])p->diagonal;
    p->in_float.upper = (const float(*)[3][3])p->upper;
    p->in_float.factor = (const float(*)[3][3])p->factor;
    p->in_float.root = (const float(*)[3][3])p->root;
}

static void allocate_double(packed_solver *p) {
    double_allocate(&p->in_double, p->A, &p->own);
    p->in_double.diagonal = (const double(*)[6])p->built.diagonal;
    p->in_double.upper = (const double(*)[3][3])p->built.upper;
    p->in_double.factor = (const double(*)[3][3])p->built.factor;
    p->in_double.root = (const double(*)[3][3])p->built.root;
}

packed_solver *packed_solver_new(const block_matrix *A, const solver_options *options) {
    packed_solver *p = calloc(1, sizeof *p);
    if (!p)
        return NULL;
    p->A = A;
    p->options = *options;
    if (factored_init(&p->built, A, p->options.preconditioner) == 0) {
        if (options->precision == PRECISION_DOUBLE)
            allocate_double(p);
        else
            allocate_float(p);
        if (!p->own.failed)
            return p;
    }
    packed_solver_free(p);
    return NULL;
}

void packed_solver_free(packed_solver *p) {
    if (!p)
        return;
    factored_free(&p->built);
    arrays_free(&p->own);
    free(p);
}

static void round_all(const double *from, float *to, size_t count) {
    for (size_t k = 0; k < count; k++)
        to[k] = (float)from[k];
}

static void build(packed_solver *p, const constraints *c) {
    const size_t rows = (size_t)p->A->row_count, blocks = (size_t)p->A->block_count;
    factored_build(&p->built, p->A, c, p->options.preconditioner);
    if (p->options.precision == PRECISION_DOUBLE)
        return;
    round_all(&p->built.diagonal[0][0], &p->diagonal[0][0], 6 * rows);
    round_all(&p->built.upper[0][0][0], &p->upper[0][0][0], 9 * blocks);
    round_all(&p->built.root[0][0][0], &p->root[0][0][0], 9 * rows);
    if (p->factor)
        round_all(&p->built.factor[0][0][0], &p->factor[0][0][0], 9 * blocks);
}

/* Transforms the residual r, in double, for the iteration. Returns r' M^-1 r. */
static double transform(packed_solver *p, const double (*r)[3]) {
    const preconditioner_kind kind = p->options.preconditioner;
    return p->options.precision == PRECISION_DOUBLE ? double_transform(&p->in_double, p->A, kind, r)
                                                    : float_transform(&p->in_float, p->A, kind, r);
}

/* Adds to dv the solution for the residual that `transform` computed. Rounding, especially in
 * float, adds small components along given directions, which the residual does not show; they are
 * projected out. */
static solver_status iterate(packed_solver *p, const constraints *c, double square, double goal,
                             long most, double (*dv)[3], long *iterations) {
    const preconditioner_kind kind = p->options.preconditioner;
    solver_status status;
    if (p->options.precision == PRECISION_DOUBLE) {
        status = double_iterate(&p->in_double, p->A, kind, square, goal, most, iterations);
        if (status != SOLVER_NOT_FINITE)
            double_add_correction(&p->in_double, p->A, kind, dv);
    } else {
        status = float_iterate(&p->in_float, p->A, kind, square, goal, most, iterations);
        if (status != SOLVER_NOT_FINITE)
            float_add_correction(&p->in_float, p->A, kind, dv);
    }
    solver_apply(c, dv);
    return status;
}

static solver_status refine(packed_solver *p, solver *s, const linear_system *system,
                            const constraints *c, double goal, long most, double (*dv)[3],
                            long *iterations) {
    const long start = *iterations;
    assert(p->options.precision == PRECISION_MIXED && goal >= 0);
    double square = transform(p, (const double(*)[3])s->residual);
    for (int n = 0; n < most_refinements; n++) {
        const double gained = float_gain * float_gain * square;
        const double before = square;
        const solver_status status = iterate(p, c, square, gained > goal ? gained : goal,
                                             most - (*iterations - start), dv, iterations);
        if (status != SOLVER_CONVERGED)
            return status;
        solver_residual(s, system, c, (const double(*)[3])dv);
        square = transform(p, (const double(*)[3])s->residual);
        if (square <= goal)
            return SOLVER_CONVERGED;
        if (!(square < 0.25 * before))
            break;
    }
    return isfinite(square) ? SOLVER_TOO_MANY_ITERATIONS : SOLVER_NOT_FINITE;
}

solver_status packed_solver_solve(packed_solver *p, solver *s, const linear_system *system,
                                  const constraints *c, const solver_limits *limits,
                                  double (*dv)[3], long *iterations) {
    build(p, c);
    solver_reference_residual(s, system, c, solver_apply(c, dv));
    const double reference = transform(p, (const double(*)[3])s->residual);
    if (!isfinite(reference))
        return SOLVER_NOT_FINITE;
    const double goal = solver_goal(limits, reference);
    solver_residual(s, system, c, (const double(*)[3])dv);
    if (p->options.precision == PRECISION_MIXED)
        return refine(p, s, system, c, goal, limits->max_iterations, dv, iterations);
    const double square = transform(p, (const double(*)[3])s->residual);
    return iterate(p, c, square, goal, limits->max_iterations, dv, iterations);
}
