/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "integrator.h"

#include <assert.h>
#include <string.h>

#include "base/clock.h"
#include "base/vector.h"
#include "forces.h"
#include "simulation_state.h"

/* A step whose slope at the end is below minus this fraction of its first slope is cut, at most
 * most_cuts times. */
static const double most_overshoot = 0.9;
enum { most_cuts = 10 };
/* Tolerance of linear systems, as a fraction of Newton's tolerance. */
static const double inner_part = 0.1;

/* Adds M (V - v_n) to b, because BDF2's base velocity V differs from v_n, the velocity at the
 * step's start. */
static void add_base(simulation *sim) {
    const integrator_memory *of = &sim->integrator;
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            sim->system.b[i][a] += sim->cloth.mass[i] * (of->base_v[i][a] - sim->state.v[i][a]);
}

void newton_assemble_at_base(simulation *sim) {
    const expansion base = {sim->step.stage_h, read_only(sim->integrator.base_x),
                            read_only(sim->state.v), read_only(sim->state.v)};
    forces_assemble(sim, &base);
    if (sim->integrator.two_states)
        add_base(sim);
}

static void add_damping(simulation *sim) {
    const integrator_memory *of = &sim->integrator;
    const triangle_material *t = &sim->cloth.triangle_material;
    if (t->stretch_damping > 0 || t->shear_damping > 0)
        triangle_damping_forces(&sim->cloth.triangles, t, sim->step.stage_h, read_only(of->at_x),
                                read_only(of->at_v), sim->system.b);
    if (sim->cloth.hinge_material.bend_damping > 0)
        hinge_damping_forces(&sim->cloth.hinges, &sim->cloth.hinge_material, sim->step.stage_h,
                             read_only(of->at_x), read_only(of->at_v), sim->system.b);
}

/* Assembles the system for dv, with forces linearised about the state that sim->step.dv leads
 * to. */
static void assemble(simulation *sim) {
    integrator_memory *of = &sim->integrator;
    const double start = clock_seconds();
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++) {
            of->at_v[i][a] = sim->state.v[i][a] + sim->step.dv[i][a];
            of->at_x[i][a] = of->base_x[i][a] + sim->step.stage_h * of->at_v[i][a];
            of->lag[i][a] = -sim->step.dv[i][a];
        }
    const expansion at = {sim->step.stage_h, read_only(of->at_x), read_only(of->lag),
                          read_only(sim->state.v)};
    forces_assemble(sim, &at);
    add_damping(sim);
    if (of->two_states)
        add_base(sim);
    collisions_add_friction(&sim->collisions, sim->step.stage_h, read_only(sim->state.v),
                            &sim->system);
    const double seconds = clock_seconds() - start;
    sim->account.phases[PHASE_FORCES].seconds += seconds;
    sim->account.phases[PHASE_SOLVE].seconds -= seconds;
}

/* Returns the norm of the residual at sim->step.dv. *reference receives the norm to which
 * tolerances are relative. */
static double defect(simulation *sim, double *reference) {
    assemble(sim);
    return solver_defect(&sim->solver, &sim->system, &sim->constraints, sim->step.dv, reference);
}

/* The slope along the last step: (dv - last) . r. */
static double slope(const simulation *sim, const double (*r)[3]) {
    double sum = 0;
    for (int i = 0; i < sim->mesh->vertex_count; i++) {
        double step[3];
        vector_subtract(sim->step.dv[i], sim->integrator.last[i], step);
        sum += vector_dot(step, r[i]);
    }
    return sum;
}

static void cut_step(simulation *sim, double factor) {
    assert(factor > 0 && factor < 1);
    for (int i = 0; i < sim->mesh->vertex_count; i++) {
        const double *from = sim->integrator.last[i];
        double step[3];
        vector_subtract(sim->step.dv[i], from, step);
        vector_add_scaled(from, factor, step, sim->step.dv[i]);
    }
}

/* Backtracking line search. Shortens the step from `last` to dv until the slope (step . residual)
 * at dv is at least -most_overshoot times `first`, the slope at `last`, or most_cuts is reached.
 * Returns the norm of the residual at dv. */
static double search(simulation *sim, double first, double *reference) {
    double size = defect(sim, reference);
    for (int cut = 0; cut < most_cuts && first > 0; cut++) {
        const double now = slope(sim, read_only(sim->solver.residual));
        if (isfinite(size) && isfinite(now) && now >= -most_overshoot * first)
            break;
        double factor = isfinite(now) ? first / (first - now) : 0.1;
        factor = factor < 0.1 ? 0.1 : factor;
        cut_step(sim, factor);
        first *= factor;
        size = defect(sim, reference);
    }
    return size;
}

static solver_status solve_linear(simulation *sim, double relative, double floor) {
    const double least = inner_part * sim->scene->solution.newton_tolerance;
    const solver_limits limits = {.tolerance = relative > least ? relative : least,
                                  .floor = inner_part * floor,
                                  .max_iterations = sim->scene->solution.max_iterations};
    sim->integrator.iterations++;
    return solver_fallback_solve(&sim->fallback, &sim->solver, &sim->system, &sim->constraints,
                                 &limits, sim->step.dv, &sim->account.iterations);
}

solver_status newton_solve(simulation *sim) {
    assert(sim->integrator.kind != INTEGRATOR_LINEAR_EULER);
    integrator_memory *of = &sim->integrator;
    const scene *s = sim->scene;
    const size_t bytes = sizeof *sim->step.dv * (size_t)sim->mesh->vertex_count;
    const double floor = 1e-3 * s->solution.newton_tolerance *
                         vector_length(s->surroundings.gravity) * sim->step.stage_h *
                         sqrt(sim->cloth.total_mass);
    double first = 0, reference;
    solver_status status = solve_linear(sim, s->solution.tolerance, floor);
    for (int n = 0; status == SOLVER_CONVERGED && n < s->solution.newton_iterations; n++) {
        const double size = search(sim, first, &reference);
        if (!isfinite(size))
            return SOLVER_NOT_FINITE;
        if (size <= s->solution.newton_tolerance * reference || size <= floor) {
            solver_impulses(&sim->solver, &sim->system, read_only(sim->step.dv));
            return SOLVER_CONVERGED;
        }
        memcpy(of->last, sim->step.dv, bytes);
        memcpy(of->last_defect, sim->solver.residual, bytes);
        status = solve_linear(sim, s->solution.tolerance * size / reference, floor);
        first = slope(sim, read_only(of->last_defect));
    }
    return status == SOLVER_CONVERGED ? SOLVER_TOO_MANY_ITERATIONS : status;
}
