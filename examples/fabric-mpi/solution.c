/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * What makes the bits those of one rank: a part's rows have all their blocks, in the order of the
 * whole matrix, so half_product gives the product's rows that the rank owns as they are there; sums
 * are over the same blocks of vertices, added in the same order (part_sum); and everything else
 * acts on single vertices. An iteration sends the ghosts' directions and gathers two sums a block.
 */
#include "solution.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "assembly.h"
#include "part_layout.h"
#include "solver_parts.h"
#include "solver_precondition.h"
#include "sparse_product.h"
#include "vector.h"

static const double (*read_only(double (*a)[3]))[3] {
    return (const double(*)[3])a;
}

/* ---- constraints ---- */

/* The leader's, of the vertices that the rank owns; ghosts are free here. */
static void receive_constraints(part *p, const constraints *whole) {
    constraints *c = &p->sim->constraints;
    const size_t count = (size_t)p->mesh.vertex_count;
    int used = whole ? whole->used : 0;
    MPI_Bcast(&used, 1, MPI_INT, LEADER, MPI_COMM_WORLD);
    memset(c->given, 0, count);
    if (used == 0)
        return;
    if (used > c->room) {
        free(c->list);
        c->list = part_memory((size_t)used, sizeof *c->list);
        c->room = used;
    }
    if (!c->place)
        c->place = part_memory(count, sizeof *c->place);
    c->used = used;
    if (whole)
        memcpy(c->list, whole->list, (size_t)used * sizeof *c->list);
    MPI_Bcast(c->list, used * (int)(sizeof *c->list / sizeof(double)), MPI_DOUBLE, LEADER,
              MPI_COMM_WORLD);
    part_receive_bytes(p, whole ? whole->given : NULL, c->given);
    part_receive_ints(p, whole ? whole->place : NULL, c->place);
}

/* ---- passes over the rows that the rank owns, one partial sum a block ---- */

/* y = A x, with the ghosts of x brought up to date. */
static void product(part *p, double (*x)[3], double (*y)[3]) {
    part_update_ghosts(p, x);
    memset(y, 0, (size_t)p->mesh.vertex_count * sizeof *y);
    half_product(&p->sim->system.A, read_only(x), y);
}

/* residual = S (b - product), preconditioned = P residual; returns r'Pr. */
static double start_residual(part *p) {
    solver *s = &p->sim->solver;
    const constraints *c = &p->sim->constraints;
    const double(*b)[3] = read_only(p->sim->system.b);
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++) {
        double sum = 0;
        for (int i = p->block[n].begin; i < p->block[n].end; i++) {
            vector_subtract(b[i], s->product[i], s->residual[i]);
            constraint_filter(c, i, s->residual[i]);
            precondition(s->inverse[i], s->residual[i], s->preconditioned[i]);
            sum += vector_dot(s->residual[i], s->preconditioned[i]);
        }
        s->sum_residual[n] = sum;
    }
    return part_sum(p, s->sum_residual);
}

/* p'Ap */
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

/* dv += alpha p, r -= alpha S A p, Pr; returns r'Pr. */
static double advance(part *p, double alpha) {
    solver *s = &p->sim->solver;
    const constraints *c = &p->sim->constraints;
    double(*dv)[3] = p->sim->dv;
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

/* p = Pr + beta p */
static void turn(part *p, double beta) {
    solver *s = &p->sim->solver;
#pragma omp parallel for schedule(static)
    for (int n = 0; n < p->blocks; n++)
        for (int i = p->block[n].begin; i < p->block[n].end; i++)
            vector_add_scaled(s->preconditioned[i], beta, s->direction[i], s->direction[i]);
}

/* ---- solutions ---- */

/* dv made to meet the constraints, and its residual. Returns r'Pr, and the reference's in
 * *reference; *which: solver_apply's, of the whole cloth. */
static double begin(part *p, const whole_system *whole, double *reference, int *which) {
    simulation *sim = p->sim;
    solver *s = &sim->solver;
    assembly_receive(p, whole ? whole->system : NULL);
    receive_constraints(p, whole ? whole->given : NULL);
    part_receive(p->own, 3, whole ? whole->dv : NULL, sim->dv);
    preconditioner_build(&sim->system.A, &sim->constraints, s->inverse);
    const int mine = solver_apply(&sim->constraints, sim->dv);
    MPI_Allreduce(&mine, which, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    memset(s->product, 0, (size_t)p->mesh.vertex_count * sizeof *s->product);
    if (*which == DRIVEN) {
        for (int i = 0; i < p->mesh.vertex_count; i++)
            memcpy(s->residual[i], constraint_change(&sim->constraints, i), sizeof *s->residual);
        product(p, s->residual, s->product);
    }
    *reference = start_residual(p);
    product(p, sim->dv, s->product);
    return start_residual(p);
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
        product(p, s->direction, s->product);
        ++*iterations;
        const double before = rz, curvature = curvature_of(p);
        rz = advance(p, curvature > 0 ? before / curvature : 0);
        turn(p, rz / before);
        if (!isfinite(curvature))
            return SOLVER_NOT_FINITE;
        if (!(curvature > 0))
            return SOLVER_BREAKDOWN;
    }
}

/* residual = b - A dv, with what the constraints take */
static void impulses(part *p) {
    solver *s = &p->sim->solver;
    product(p, p->sim->dv, s->product);
    for (int i = 0; i < p->mesh.vertex_count; i++)
        vector_subtract(p->sim->system.b[i], s->product[i], s->residual[i]);
}

static void give_back(part *p, const whole_system *whole) {
    part_return(p, 3, p->sim->solver.residual, whole ? whole->residual : NULL);
    part_return(p, 3, p->sim->dv, whole ? whole->dv : NULL);
}

solver_status solution_solve(part *p, const whole_system *whole, const solver_limits *limits,
                             long *iterations) {
    solver_limits now = {0};
    solver *s = &p->sim->solver;
    double reference;
    int which;
    part_stage_begin("solution");
    if (limits)
        now = *limits;
    MPI_Bcast(&now, (int)sizeof now, MPI_BYTE, LEADER, MPI_COMM_WORLD);
    const double rz = begin(p, whole, &reference, &which);
    memcpy(s->direction, s->preconditioned, (size_t)p->mesh.vertex_count * sizeof *s->direction);
    const solver_status status =
        !isfinite(reference)
            ? SOLVER_NOT_FINITE
            : iterate_to(solver_goal(&now, reference), p, now.max_iterations, rz, iterations);
    if (which != UNCONSTRAINED && status != SOLVER_NOT_FINITE)
        impulses(p);
    give_back(p, whole);
    part_stage_end();
    return status;
}

double solution_defect(part *p, const whole_system *whole, double *reference) {
    int which;
    part_stage_begin("solution");
    const double rz = begin(p, whole, reference, &which);
    *reference = sqrt(*reference);
    give_back(p, whole);
    part_stage_end();
    return sqrt(rz);
}

void solution_impulses(part *p, const whole_system *whole) {
    part_stage_begin("solution");
    assembly_receive(p, whole ? whole->system : NULL);
    part_receive(p->own, 3, whole ? whole->dv : NULL, p->sim->dv);
    impulses(p);
    part_return(p, 3, p->sim->solver.residual, whole ? whole->residual : NULL);
    part_stage_end();
}
