/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Gauss-Seidel over parts, with the passes of fabric's solver_domains.c in their order. A rank
 * sweeps the domains that it owns. A sweep reads of other ranks what domains of the other kind have
 * there: these ghosts, of odd domains or of even ones, are brought up to date in between. */
#include <math.h>
#include <string.h>

#include "solution_parts.h"
#include "solver_domains_parts.h"
#include "solver_parts.h"
#include "sparse_product.h"
#include "vector.h"

static const double (*read_only(double (*a)[3]))[3] {
    return (const double(*)[3])a;
}

static int is_of_kind(const part *p, int n, int odd) {
    return p->block[n].number % 2 == odd;
}

/* The first half of r = (I + U)^-T r; then what the other half reads of other ranks is there. */
static void sweep_even_down(const part *p, double (*r)[3]) {
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++)
        if (is_of_kind(p, n, 0))
            domain_sweep_down(p->domains, p->block[n].number, r);
}

/* The solver's residual, within the constraints, transformed; returns its square. */
static double transform(part *p) {
    domain_solver *d = p->domains;
    solver_filter(&p->sim->constraints, p->sim->solver.residual);
    domain_scale(d, read_only(p->sim->solver.residual));
    sweep_even_down(p, d->residual);
    part_update_kind(p, 0, d->residual);
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++)
        d->sum_residual[n] = domain_transform(d, p->block[n].number);
    return part_sum(p, d->sum_residual);
}

/* p = residual + beta p; NULL: p is there. Then t, and w but for its product with what is between
 * domains. A domain is turned just before it is swept, so that it is read from memory once. */
static void sweep_direction(const part *p, const double *beta) {
    domain_solver *d = p->domains;
    for (int odd = 1; odd >= 0; odd--) {
#pragma omp parallel for schedule(static)
        for (int n = 0; n < p->blocks; n++) {
            if (!is_of_kind(p, n, odd))
                continue;
            if (beta)
                domain_turn(d, p->block[n].number, *beta);
            domain_sweep_direction(d, p->block[n].number);
        }
        if (odd || d->has_between)
            part_update_kind(p, odd, d->swept);
    }
}

/* w, of even domains swept down. */
static void finish_even(const part *p) {
    domain_solver *d = p->domains;
    if (d->has_between) {
        half_product(&d->between, read_only(d->swept), d->image);
        sweep_even_down(p, d->image);
    }
    part_update_kind(p, 0, d->image);
}

/* p . image */
static double curvature_of(const part *p) {
    domain_solver *d = p->domains;
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++)
        d->sum_direction[n] = domain_finish_image(d, p->block[n].number);
    return part_sum(p, d->sum_direction);
}

/* Returns the residual's square. */
static double advance(const part *p, double alpha) {
    domain_solver *d = p->domains;
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++)
        d->sum_residual[n] = domain_advance(d, p->block[n].number, alpha);
    return part_sum(p, d->sum_residual);
}

static void begin(const part *p) {
    domain_solver *d = p->domains;
    const size_t size = sizeof(double[3]) * (size_t)p->mesh.vertex_count;
    memset(d->correction, 0, size);
    memcpy(d->direction, d->residual, size);
    sweep_direction(p, NULL);
}

static solver_status iterate(part *p, double square, double goal, int most, long *iterations) {
    begin(p);
    for (int k = 0;; k++) {
        if (!isfinite(square))
            return SOLVER_NOT_FINITE;
        if (square <= goal)
            return SOLVER_CONVERGED;
        if (k == most)
            return SOLVER_TOO_MANY_ITERATIONS;
        finish_even(p);
        ++*iterations;
        const double before = square, curvature = curvature_of(p);
        square = advance(p, curvature > 0 ? before / curvature : 0);
        const double beta = square / before;
        sweep_direction(p, &beta);
        if (!isfinite(curvature))
            return SOLVER_NOT_FINITE;
        if (!(curvature > 0))
            return SOLVER_BREAKDOWN;
    }
}

/* dv += the correction, which is swept up first. */
static void add_correction(const part *p) {
    domain_solver *d = p->domains;
    for (int odd = 1; odd >= 0; odd--) {
#pragma omp parallel for schedule(static)
        for (int n = 0; n < p->blocks; n++)
            if (is_of_kind(p, n, odd))
                domain_sweep_up(d, p->block[n].number, read_only(d->correction), d->correction);
        if (odd)
            part_update_kind(p, odd, d->correction);
    }
    domain_add_correction(d, p->sim->dv);
}

solver_status domains_solve(part *p, const solver_limits *limits, int which, long *iterations) {
    domain_build(p->domains, &p->sim->constraints);
    solution_reference(p, which);
    const double reference = transform(p);
    if (!isfinite(reference))
        return SOLVER_NOT_FINITE;
    solution_residual(p, p->sim->dv);
    const double square = transform(p);
    const solver_status status =
        iterate(p, square, solver_goal(limits, reference), limits->max_iterations, iterations);
    if (status != SOLVER_NOT_FINITE)
        add_correction(p);
    solver_apply(&p->sim->constraints, p->sim->dv);
    return status;
}
