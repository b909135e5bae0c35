/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Conjugate gradients with block-Jacobi over parts, with the operations of fabric's solver.c in
 * their order. Sums are over the same blocks of vertices, added in the same order (part_sum), and
 * all operations except the product act on single vertices. An iteration sends the ghosts'
 * directions and gathers two sums per block. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "part_layout.h"
#include "solution_parts.h"
#include "solver/solver_parts.h"
#include "solver/solver_precondition.h"

/* Sets residual r = S (b - product) and preconditioned = P r. */
static void start_residual(part *p) {
    solver *s = &p->sim->solver;
    const constraints *c = &p->sim->constraints;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < p->mesh.vertex_count; i++) {
        vector_subtract(p->sim->system.b[i], s->product[i], s->residual[i]);
        constraint_filter(c, i, s->residual[i]);
        precondition(s->inverse[i], s->residual[i], s->preconditioned[i]);
    }
}

/* Returns r'Pr, summed by chunks of SOLVER_CHUNK vertices even if the part's blocks are domains. */
static double residual_square(part *p) {
    solver *s = &p->sim->solver;
    double *term = part_memory((size_t)p->mesh.vertex_count, sizeof *term), sum;
    for (int n = 0; n < p->blocks; n++)
        for (int i = p->block[n].begin; i < p->block[n].end; i++)
            term[i] = vector_dot(s->residual[i], s->preconditioned[i]);
    for (int n = 0; n < p->blocks && !p->domains; n++)
        s->sum_residual[n] =
            solver_sum(term + p->block[n].begin, p->block[n].end - p->block[n].begin);
    sum = p->domains ? part_sum_terms(p, term) : part_sum(p, s->sum_residual);
    free(term);
    return sum;
}

/* Returns p'Ap for the direction p. */
static double curvature_of(part *p) {
    solver *s = &p->sim->solver;
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++) {
        double sum = 0;
        for (int i = p->block[n].begin; i < p->block[n].end; i++)
            sum += vector_dot(s->direction[i], s->product[i]);
        s->sum_direction[n] = sum;
    }
    return part_sum(p, s->sum_direction);
}

/* Sets dv += alpha p and r -= alpha S A p, and recomputes P r. Returns r'Pr. */
static double advance(part *p, double alpha) {
    solver *s = &p->sim->solver;
    const constraints *c = &p->sim->constraints;
    double(*dv)[3] = p->sim->step.dv;
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++) {
        double sum = 0;
        for (int i = p->block[n].begin; i < p->block[n].end; i++) {
            vector_add_scaled(dv[i], alpha, s->direction[i], dv[i]);
            constraint_filter(c, i, s->product[i]);
            vector_add_scaled(s->residual[i], -alpha, s->product[i], s->residual[i]);
            precondition(s->inverse[i], s->residual[i], s->preconditioned[i]);
            sum += vector_dot(s->residual[i], s->preconditioned[i]);
        }
        s->sum_residual[n] = sum;
    }
    return part_sum(p, s->sum_residual);
}

/* Sets p = P r + beta p. */
static void update_direction(part *p, double beta) {
    solver *s = &p->sim->solver;
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++)
        for (int i = p->block[n].begin; i < p->block[n].end; i++)
            vector_add_scaled(s->preconditioned[i], beta, s->direction[i], s->direction[i]);
}

/* Computes preconditioner and residual. Returns r'Pr; *reference receives r'Pr of the reference
 * residual. */
static double begin(part *p, int which, double *reference) {
    simulation *sim = p->sim;
    solver *s = &sim->solver;
    preconditioner_build(&sim->system.A, &sim->constraints, s->inverse);
    memset(s->product, 0, (size_t)p->mesh.vertex_count * sizeof *s->product);
    if (which == DRIVEN) {
        for (int i = 0; i < p->mesh.vertex_count; i++)
            memcpy(s->residual[i], constraint_change(&sim->constraints, i), sizeof *s->residual);
        solution_product(p, s->residual, s->product);
    }
    start_residual(p);
    *reference = residual_square(p);
    solution_product(p, sim->step.dv, s->product);
    start_residual(p);
    return residual_square(p);
}

static solver_status iterate_to(double goal, part *p, int max_iterations, double rz,
                                long *iterations) {
    solver *s = &p->sim->solver;
    for (int k = 0;; k++) {
        if (!isfinite(rz))
            return SOLVER_NOT_FINITE;
        if (rz <= goal)
            return SOLVER_CONVERGED;
        if (k == max_iterations)
            return SOLVER_TOO_MANY_ITERATIONS;
        solution_product(p, s->direction, s->product);
        ++*iterations;
        const double before = rz, curvature = curvature_of(p);
        rz = advance(p, curvature > 0 ? before / curvature : 0);
        update_direction(p, rz / before);
        if (!isfinite(curvature))
            return SOLVER_NOT_FINITE;
        if (!(curvature > 0))
            return SOLVER_BREAKDOWN;
    }
}

solver_status jacobi_solve(part *p, const solver_limits *limits, int which, long *iterations) {
    solver *s = &p->sim->solver;
    double reference;
    const double rz = begin(p, which, &reference);
    memcpy(s->direction, s->preconditioned, (size_t)p->mesh.vertex_count * sizeof *s->direction);
    if (!isfinite(reference))
        return SOLVER_NOT_FINITE;
    return iterate_to(solver_goal(limits, reference), p, limits->max_iterations, rz, iterations);
}

double jacobi_defect(part *p, int which, double *reference) {
    const double rz = begin(p, which, reference);
    *reference = sqrt(*reference);
    return sqrt(rz);
}
