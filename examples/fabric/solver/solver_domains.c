/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Let C C' be the diagonal blocks of the prefiltered matrix (solver_precondition.h), divided by the
 * relaxation factor. The scaled matrix, with its diagonal blocks D^, is
 *     A^ = C^-1 A C^-T = D^ + U + U' + E + E'
 * Vertices are divided into domains of consecutive numbers, and reordered: all even domains come
 * before all odd ones. E has the blocks between two different even or two different odd domains,
 * and U all other blocks above the diagonal in that order. E has few blocks: if neighbours have
 * near numbers, a domain touches only the ones before and after it. So all even domains, and then
 * all odd ones, are swept in parallel. The preconditioner is (I + U)' (I + U), and the iteration
 * runs on (I + U)^-T A^ (I + U)^-1. With t = (I + U)^-1 p the image of a direction p is (Eisenstat
 * 1981)
 *     t + (I + U)^-T w        w = p + (D^ - 2 I + E + E') t
 * so that each stored block of A is used twice per iteration, as in half_product.
 */
#include <math.h>
#include <string.h>

#include "solver_domains_parts.h"

/* The first half of r = (I + U)^-T r: the even domains. */
static void sweep_even_down(domain_solver *d, double (*r)[3]) {
#pragma omp parallel for schedule(static)
    for (int domain = 0; domain < d->count; domain += 2)
        domain_sweep_down(d, domain, r);
}

/* Sets the residual to the transformed r. Returns its squared norm, r' M^-1 r with the
 * preconditioner M. */
static double transform(domain_solver *d, const double (*r)[3]) {
    domain_scale(d, r);
    sweep_even_down(d, d->residual);
#pragma omp parallel for schedule(static)
    for (int domain = 0; domain < d->count; domain++)
        d->sum_residual[domain] = domain_transform(d, domain);
    return solver_sum(d->sum_residual, d->count);
}

/* Adds the correction to dv, after the correction's upward sweep. */
static void add_correction(domain_solver *d, double (*dv)[3]) {
#pragma omp parallel
    for (int odd = 1; odd >= 0; odd--) {
#pragma omp for schedule(static)
        for (int domain = odd; domain < d->count; domain += 2)
            domain_sweep_up(d, domain, (const double(*)[3])d->correction, d->correction);
    }
    domain_add_correction(d, dv);
}

/* Sets correction = 0 and p = the residual, and begins the first iteration. */
static void begin(domain_solver *d) {
    const size_t size = sizeof(double[3]) * (size_t)d->A->row_count;
    memset(d->correction, 0, size);
    memcpy(d->direction, d->residual, size);
#pragma omp parallel
    for (int odd = 1; odd >= 0; odd--) {
#pragma omp for schedule(static)
        for (int domain = odd; domain < d->count; domain += 2)
            domain_sweep_direction(d, domain);
    }
}

/* Does all of an iteration except the product with `between`. *square is r . r, which it updates.
 * Returns p . image; if that is not positive, correction and residual do not change. Every thread
 * adds up the domains' sums itself. */
static double finish_iteration(domain_solver *d, double *square) {
    const double before = *square;
#pragma omp parallel
    {
        double curvature, after;
#pragma omp for schedule(static)
        for (int domain = 0; domain < d->count; domain++)
            d->sum_direction[domain] = domain_finish_image(d, domain);
        curvature = solver_sum(d->sum_direction, d->count);
#pragma omp for schedule(static)
        for (int domain = 0; domain < d->count; domain++)
            d->sum_residual[domain] =
                domain_advance(d, domain, curvature > 0 ? before / curvature : 0);
        after = solver_sum(d->sum_residual, d->count);
        for (int odd = 1; odd >= 0; odd--) {
#pragma omp for schedule(static)
            for (int domain = odd; domain < d->count; domain += 2) {
                domain_update_direction(d, domain, after / before);
                domain_sweep_direction(d, domain);
            }
        }
    }
    *square = solver_sum(d->sum_residual, d->count);
    return solver_sum(d->sum_direction, d->count);
}

/* Iterates from the residual that `transform` computed, until its squared norm, at first `square`,
 * is at most `goal`. */
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
        if (d->has_between) {
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
    domain_build(d, c);
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
    solver_apply(c, dv); /* removes the correction's rounding errors along given directions */
    return status;
}
