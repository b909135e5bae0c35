/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Gauss-Seidel over parts, with the passes of fabric's solver_domains.c in their order. A rank
 * sweeps the domains that it owns. A sweep of even domains reads values of odd ones, and vice
 * versa, so ghosts in these are updated between the sweeps. */
#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "solution_parts.h"
#include "solver/solver_domains_parts.h"
#include "solver/solver_parts.h"

static const double (*read_only(double (*a)[3]))[3] {
    return (const double(*)[3])a;
}

/* A pass over one domain. Unless NULL, `beta` is used to update the direction first. */
typedef void (*domain_pass)(domain_solver *d, int domain, const double *beta);

/* Makes a pass over the even or the odd domains, after which other ranks have these domains' values
 * of `sent` (unless NULL). Domains that other ranks read come first. Their values are sent while
 * the other domains are computed, so that a rank that is briefly late delays no other rank. */
static void pass_over(const part *p, int odd, domain_pass pass, const double *beta,
                      double (*sent)[3]) {
    for (int sends = 1; sends >= 0; sends--) {
#pragma omp parallel for schedule(dynamic)
        for (int n = 0; n < p->blocks; n++)
            if (p->block[n].number % 2 == odd && p->block[n].sends == sends)
                pass(p->domains, p->block[n].number, beta);
        if (sends && sent)
            part_update_kind_begin(p, odd, sent);
    }
    if (sent)
        part_update_kind_end(p, odd, sent);
}

static void sweep_residual_down(domain_solver *d, int domain, const double *beta) {
    (void)beta;
    domain_sweep_down(d, domain, d->residual);
}

static void sweep_image_down(domain_solver *d, int domain, const double *beta) {
    (void)beta;
    domain_sweep_down(d, domain, d->image);
}

static void sweep_correction_up(domain_solver *d, int domain, const double *beta) {
    (void)beta;
    domain_sweep_up(d, domain, read_only(d->correction), d->correction);
}

/* A domain's direction is updated just before the domain is swept, so that it is read from memory
 * once.
 */
static void update_and_sweep_direction(domain_solver *d, int domain, const double *beta) {
    if (beta)
        domain_update_direction(d, domain, *beta);
    domain_sweep_direction(d, domain);
}

/* Filters and transforms the solver's residual. Returns its squared norm. */
static double transform(part *p) {
    domain_solver *d = p->domains;
    solver_filter(&p->sim->constraints, p->sim->solver.residual);
    domain_scale(d, read_only(p->sim->solver.residual));
    pass_over(p, 0, sweep_residual_down, NULL, d->residual);
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++)
        d->sum_residual[n] = domain_transform(d, p->block[n].number);
    return part_sum(p, d->sum_residual);
}

/* Sets p = residual + beta p, unless beta is NULL. Then computes t, and w without its product with
 * `between`. */
static void sweep_direction(const part *p, const double *beta) {
    domain_solver *d = p->domains;
    pass_over(p, 1, update_and_sweep_direction, beta, d->swept);
    pass_over(p, 0, update_and_sweep_direction, beta, d->has_between ? d->swept : NULL);
}

/* Completes w, and sweeps even domains down. */
static void finish_even(const part *p) {
    domain_solver *d = p->domains;
    if (d->has_between) {
        half_product(&d->between, read_only(d->swept), d->image);
        pass_over(p, 0, sweep_image_down, NULL, d->image);
        return;
    }
    part_update_kind_begin(p, 0, d->image);
    part_update_kind_end(p, 0, d->image);
}

/* Returns p . image. */
static double curvature_of(const part *p) {
    domain_solver *d = p->domains;
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++)
        d->sum_direction[n] = domain_finish_image(d, p->block[n].number);
    return part_sum(p, d->sum_direction);
}

/* Advances correction and residual. Returns the residual's squared norm. */
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

/* Adds the correction to dv, after the correction's upward sweep. */
static void add_correction(const part *p) {
    domain_solver *d = p->domains;
    pass_over(p, 1, sweep_correction_up, NULL, d->correction);
    pass_over(p, 0, sweep_correction_up, NULL, NULL);
    domain_add_correction(d, p->sim->step.dv);
}

solver_status domains_solve(part *p, const solver_limits *limits, int which, long *iterations) {
    domain_build(p->domains, &p->sim->constraints);
    solution_reference(p, which);
    const double reference = transform(p);
    if (!isfinite(reference))
        return SOLVER_NOT_FINITE;
    solution_residual(p, p->sim->step.dv);
    const double square = transform(p);
    const solver_status status =
        iterate(p, square, solver_goal(limits, reference), limits->max_iterations, iterations);
    if (status != SOLVER_NOT_FINITE)
        add_correction(p);
    solver_apply(&p->sim->constraints, p->sim->step.dv);
    return status;
}
