/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Let C C' be the diagonal blocks of the prefiltered matrix (solver_precondition.h), divided by the
 * relaxation factor. The scaled matrix, with its diagonal blocks D^, is
 *     A^ = C^-1 A C^-T = D^ + U + U' + E + E'
 * Vertices are divided into domains of consecutive numbers, and reordered: all even domains come
 * before all odd ones. E has the blocks between two different even or two different odd domains,
 * and U all other blocks above the diagonal in that order. E has few blocks: if neighbours have
 * near numbers, a domain touches only the ones before and after it. So all even domains are swept
 * in parallel, and so are all odd ones. A thread has the same domains in all passes, and waits only
 * for the neighbours of the domain that it sweeps (solver_domains_turns.h). The preconditioner is
 * (I + U)' (I + U), and the iteration runs on (I + U)^-T A^ (I + U)^-1. With t = (I + U)^-1 p the
 * image of a direction p is (Eisenstat 1981)
 *     t + (I + U)^-T w        w = p + (D^ - 2 I + E + E') t
 * so that each stored block of A is used twice per iteration, as in half_product.
 */
#include <math.h>
#include <string.h>

#include "solver_domains_parts.h"

/** A thread's domains: from `first` up to, but not including, `end`. */
typedef struct domain_share {
    int first, end;
} domain_share;

/* Returns the calling thread's share, from inside a parallel region. */
static domain_share share_of(const domain_solver *d) {
    domain_share own = {d->count, 0};
#pragma omp for schedule(static) nowait
    for (int domain = 0; domain < d->count; domain++) {
        own.first = domain < own.first ? domain : own.first;
        own.end = domain + 1;
    }
    return own;
}

/* The share's first odd domain, and its last even one. */
static int first_odd(const domain_share *own) {
    return own->first | 1;
}

static int last_even(const domain_share *own) {
    return (own->end - 1) & ~1;
}

/* The first half of r = (I + U)^-T r: the even domains. Ends their pass 1. */
static void sweep_even_down(domain_solver *d, const domain_share *own, double (*r)[3]) {
    for (int domain = last_even(own); domain >= own->first; domain -= 2) {
        domain_sweep_down(d, domain, r);
        domain_turn_end(&d->turn[domain], 1);
    }
}

/* Sets the residual to the transformed r. Returns its squared norm, r' M^-1 r with the
 * preconditioner M. */
static double transform(domain_solver *d, const double (*r)[3]) {
    domain_scale(d, r);
    domain_turns_begin(d->turn, d->count);
#pragma omp parallel
    {
        const domain_share own = share_of(d);
        sweep_even_down(d, &own, d->residual);
        for (int domain = own.first; domain < own.end; domain++) {
            if (domain % 2)
                domain_turn_await(d->turn, domain, 1);
            d->sum_residual[domain] = domain_transform(d, domain);
        }
    }
    return solver_sum(d->sum_residual, d->count);
}

/* Adds the correction to dv, after the correction's upward sweep. */
static void add_correction(domain_solver *d, double (*dv)[3]) {
    const double(*from)[3] = (const double(*)[3])d->correction;
    domain_turns_begin(d->turn, d->count);
#pragma omp parallel
    {
        const domain_share own = share_of(d);
        for (int domain = first_odd(&own); domain < own.end; domain += 2) {
            domain_sweep_up(d, domain, from, d->correction);
            domain_turn_end(&d->turn[domain], 1);
        }
        for (int domain = last_even(&own); domain >= own.first; domain -= 2) {
            domain_turn_await(d->turn, domain, 1);
            domain_sweep_up(d, domain, from, d->correction);
        }
    }
    domain_add_correction(d, dv);
}

/** The state of the iteration. Each thread has a copy, with the same values. */
typedef struct progress {
    double square; /* r . r */
    long iterations;
    solver_status status; /* if goes_on is 0 */
    int goes_on;
} progress;

/* Decides whether another iteration follows one whose direction p had this p . image. */
static void decide(progress *p, double curvature, double goal, long most) {
    p->goes_on = 0;
    if (!isfinite(curvature))
        p->status = SOLVER_NOT_FINITE;
    else if (!(curvature > 0))
        p->status = SOLVER_BREAKDOWN;
    else if (!isfinite(p->square))
        p->status = SOLVER_NOT_FINITE;
    else if (p->square <= goal)
        p->status = SOLVER_CONVERGED;
    else if (p->iterations == most)
        p->status = SOLVER_TOO_MANY_ITERATIONS;
    else
        p->goes_on = 1;
}

static void sweep_one(domain_solver *d, int domain, const double *beta, unsigned pass) {
    if (beta)
        domain_update_direction(d, domain, *beta);
    domain_sweep_direction(d, domain);
    domain_turn_end(&d->turn[domain], pass);
}

/* Sets p = the residual + beta p, unless beta is NULL, and sweeps it, in the pass 2 iterations + 1
 * of odd domains and the next pass of even ones. Even domains come in descending order, so that the
 * one that the next thread waits for is the first. */
static void sweep_direction(domain_solver *d, const domain_share *own, const double *beta,
                            long iterations) {
    const unsigned pass = 2 * (unsigned)iterations + 1;
    for (int domain = first_odd(own); domain < own->end; domain += 2)
        sweep_one(d, domain, beta, pass);
    for (int domain = last_even(own); domain >= own->first; domain -= 2) {
        domain_turn_await(d->turn, domain, pass);
        sweep_one(d, domain, beta, pass + 1);
    }
}

/* Computes p . image after the passes of sweep_direction. Every thread adds up the domains' sums
 * itself. */
static double finish_image(domain_solver *d, const domain_share *own, long iterations) {
    for (int domain = own->first; domain < own->end; domain++) {
        if (domain % 2)
            domain_turn_await(d->turn, domain, 2 * (unsigned)iterations + 2);
        d->sum_direction[domain] = domain_finish_image(d, domain);
    }
#pragma omp barrier
    return solver_sum(d->sum_direction, d->count);
}

/* Does all of an iteration except the product with `between`, and sweeps the next direction, if one
 * is needed. If p . image is not positive, correction and residual do not change. */
static void finish_iteration(domain_solver *d, const domain_share *own, double goal, long most,
                             progress *p) {
    const double before = p->square, curvature = finish_image(d, own, p->iterations);
    for (int domain = own->first; domain < own->end; domain++)
        d->sum_residual[domain] = domain_advance(d, domain, curvature > 0 ? before / curvature : 0);
#pragma omp barrier
    p->square = solver_sum(d->sum_residual, d->count);
    p->iterations++;
    decide(p, curvature, goal, most);
    const double beta = p->square / before;
    if (p->goes_on)
        sweep_direction(d, own, &beta, p->iterations);
}

/* Sets correction = 0 and p = the residual, which it sweeps. */
static void begin(domain_solver *d) {
    const size_t size = sizeof(double[3]) * (size_t)d->A->row_count;
    memset(d->correction, 0, size);
    memcpy(d->direction, d->residual, size);
    domain_turns_begin(d->turn, d->count);
#pragma omp parallel
    {
        const domain_share own = share_of(d);
        sweep_direction(d, &own, NULL, 0);
    }
}

/* Adds the product with `between` to the image, and sweeps even domains down. */
static void add_between(domain_solver *d) {
    half_product(&d->between, (const double(*)[3])d->swept, d->image);
#pragma omp parallel for schedule(static)
    for (int domain = 0; domain < d->count; domain += 2)
        domain_sweep_down(d, domain, d->image);
}

/* Iterates from the residual that `transform` computed, until its squared norm, at first `square`,
 * is at most `goal`. Only a product with `between` ends the parallel region. */
static solver_status iterate(domain_solver *d, double square, double goal, long most,
                             long *iterations) {
    progress all = {.square = square};
    begin(d);
    decide(&all, 1, goal, most);
    while (all.goes_on) {
        if (d->has_between)
            add_between(d);
#pragma omp parallel
        {
            const domain_share share = share_of(d);
            progress own = all;
            do
                finish_iteration(d, &share, goal, most, &own);
            while (own.goes_on && !d->has_between);
#pragma omp single nowait
            all = own;
        }
    }
    *iterations += all.iterations;
    return all.status;
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
