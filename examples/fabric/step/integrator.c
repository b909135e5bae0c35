/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "integrator.h"

#include <assert.h>
#include <string.h>

#include "barrier_step.h"
#include "base/clock.h"
#include "base/vector.h"
#include "contact/impact.h"
#include "forces.h"
#include "simulation_state.h"
#include "timing.h"

/* BDF2 is stable if a step is no longer than 1 + sqrt(2) times the one before (Grigorieff 1983).
 * Lengths grow by 2, and by more only after a step that was cut at an event. */
static const double most_growth = 2.1;

/* Limit of solutions per step: after each solution, unexpected contacts are added for the next. */
enum { most_solutions = 3 };

int integrator_init(integrator_memory *memory, integrator_kind kind, int vertex_count) {
    *memory = (integrator_memory){.kind = kind};
    if (kind == INTEGRATOR_LINEAR_EULER)
        return 0;
    double(**const vectors[])[3] = {&memory->base_x,      &memory->base_v,   &memory->at_x,
                                    &memory->at_v,        &memory->lag,      &memory->last,
                                    &memory->last_defect, &memory->x_before, &memory->v_before};
    const int count = kind == INTEGRATOR_BDF2 ? 9 : 7;
    assert((size_t)count <= sizeof vectors / sizeof *vectors);
    for (int k = 0; k < count; k++)
        *vectors[k] = arrays_add(&memory->own, (size_t)vertex_count + 1, sizeof(double[3]));
    return memory->own.failed ? -1 : 0;
}

void integrator_free(integrator_memory *memory) {
    arrays_free(&memory->own);
    *memory = (integrator_memory){0};
}

/* Sets X, V and tau of the current step; with two_states by BDF2, from the last two states. */
static void set_stage(simulation *sim, int two_states) {
    assert(!two_states ||
           (sim->integrator.kind == INTEGRATOR_BDF2 && sim->integrator.h_before > 0));
    integrator_memory *of = &sim->integrator;
    const double ratio = two_states ? sim->step.h / of->h_before : 0;
    const double newer = (1 + ratio) * (1 + ratio) / (1 + 2 * ratio);
    const double older = ratio * ratio / (1 + 2 * ratio);
    of->two_states = two_states;
    sim->step.stage_h = of->kind == INTEGRATOR_MIDPOINT ? sim->step.h / 2
                        : two_states ? (1 + ratio) / (1 + 2 * ratio) * sim->step.h
                                     : sim->step.h;
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++) {
            of->base_x[i][a] = sim->state.x[i][a];
            of->base_v[i][a] = sim->state.v[i][a];
            if (two_states) {
                of->base_x[i][a] = newer * sim->state.x[i][a] - older * of->x_before[i][a];
                of->base_v[i][a] = newer * sim->state.v[i][a] - older * of->v_before[i][a];
            }
        }
}

void evaluateForces(simulation *sim) {
    if (sim->barrier) {
        barrier_step_forces(sim);
        return;
    }
    timing_begin(sim);
    if (sim->integrator.kind == INTEGRATOR_LINEAR_EULER) {
        const expansion start = {sim->step.h, read_only(sim->state.x), read_only(sim->state.v),
                                 read_only(sim->state.v)};
        sim->step.stage_h = sim->step.h;
        forces_assemble(sim, &start);
        return;
    }
    set_stage(sim, sim->integrator.kind == INTEGRATOR_BDF2 &&
                       sim->step.h <= most_growth * sim->integrator.h_before);
    newton_assemble_at_base(sim);
}

static int has_contact(const simulation *sim) {
    if (!sim->collisions.now)
        return 0;
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        if (sim->collisions.now[i].count > 0)
            return 1;
    return 0;
}

/* Makes the step a backward Euler step. A contact destroys the smoothness that BDF2 assumes, and
 * the position extrapolated from two states may lie behind a thin collider. */
static void leave_two_states(simulation *sim) {
    set_stage(sim, 0);
    newton_assemble_at_base(sim);
    collisions_add_friction(&sim->collisions, sim->step.stage_h, read_only(sim->state.v),
                            &sim->system);
}

/* Returns the mean velocity over the step that leads to x = X + tau (v + dv), minus the velocity v
 * at its start. Contacts need it. */
static const double (*mean_change(simulation *sim))[3] {
    const integrator_memory *of = &sim->integrator;
    if (!of->two_states)
        return read_only(sim->step.dv);
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            of->last[i][a] = (of->base_x[i][a] - sim->state.x[i][a] +
                              sim->step.stage_h * (sim->state.v[i][a] + sim->step.dv[i][a])) /
                                 sim->step.h -
                             sim->state.v[i][a];
    return read_only(of->last);
}

static solver_status solve_stage(simulation *sim) {
    if (sim->integrator.kind != INTEGRATOR_LINEAR_EULER)
        return newton_solve(sim);
    const double fall = vector_length(sim->scene->surroundings.gravity) * sim->step.h;
    const solver_limits limits = {
        .tolerance = sim->scene->solution.tolerance,
        /* At rest b is nearly 0, so the floor is relative to the effect of gravity in a step. */
        .floor = 1e-3 * sim->scene->solution.tolerance * fall * sqrt(sim->cloth.total_mass),
        .max_iterations = sim->scene->solution.max_iterations,
    };
    return solver_fallback_solve(&sim->fallback, &sim->solver, &sim->system, &sim->constraints,
                                 &limits, sim->step.dv, &sim->account.iterations);
}

/* Adds forces that begin to act within the step, for the linear method only: Newton's method finds
 * such forces at its iterates. Returns their number. */
static int add_missed_forces(simulation *sim) {
    const expansion start = {sim->step.h, read_only(sim->state.x), read_only(sim->state.v),
                             read_only(sim->state.v)};
    if (sim->integrator.kind != INTEGRATOR_LINEAR_EULER)
        return 0;
    return forces_add_missed(sim, &start, read_only(sim->step.dv));
}

void solveSystem(simulation *sim) {
    if (sim->barrier) {
        barrier_step_solve(sim);
        return;
    }
    if (sim->integrator.two_states && has_contact(sim))
        leave_two_states(sim);
    for (int n = 0; n < most_solutions; n++) {
        sim->step.solver_status = solve_stage(sim);
        if (sim->step.solver_status != SOLVER_CONVERGED || n + 1 == most_solutions)
            return;
        const int contacts = BUILT_WITH(EFFECT_CONTACT) == 0
                                 ? 0
                                 : collisions_add_missed(&sim->collisions, simulation_time(sim),
                                                         sim->step.h, read_only(sim->state.x),
                                                         read_only(sim->state.v), mean_change(sim));
        if (add_missed_forces(sim) == 0 && contacts == 0)
            return;
        if (contacts == 0)
            continue;
        if (collisions_constrain(&sim->collisions, read_only(sim->state.v), &sim->constraints) != 0)
            sim->step.out_of_memory = 1;
        if (sim->integrator.kind != INTEGRATOR_LINEAR_EULER)
            leave_two_states(sim);
    }
}

/* Converts v_next from the mean velocity over the step to the velocity at its end. */
static void end_velocity(simulation *sim, const double (*mean)[3]) {
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++) {
            const double pushed = sim->step.v_next[i][a] - (sim->state.v[i][a] + mean[i][a]);
            sim->step.v_next[i][a] = sim->state.v[i][a] + sim->step.dv[i][a] + pushed;
            /* The implicit midpoint doubles dv, except in directions in which the velocity is
             * prescribed: there a vertex would bounce off the collider. */
            if (sim->integrator.kind == INTEGRATOR_MIDPOINT)
                sim->step.v_next[i][a] +=
                    vector_dot(constraint_projection(&sim->constraints, i)[a], sim->step.dv[i]);
        }
}

/* Changes v_next so that the cloth passes through neither itself nor a body. Returns 0, or -1 if
 * out of memory or if a number is not finite. */
static int resolve_contacts(simulation *sim) {
    const int itself = effect_is_on(sim, EFFECT_SELF_COLLISION);
    effect_account *account = &sim->account.effects[EFFECT_SELF_COLLISION];
    const double start = clock_seconds();
    impact_step step = {
        .time = simulation_time(sim),
        .h = sim->step.h,
        .x = read_only(sim->state.x),
        .v = sim->step.v_next,
        .of = {sim->cloth.mass, &sim->collisions},
        .itself = itself ? &sim->self_collision : NULL,
        .bodies = &sim->collisions,
    };
    const int status = impact_resolve(&step, &sim->step.push_work);
    if (itself) {
        account->visited = sim->self_collision.visits;
        account->seconds += clock_seconds() - start;
    }
    return status;
}

int integrator_move(simulation *sim) {
    if (sim->barrier)
        return barrier_step_move(sim);
    const int count = sim->mesh->vertex_count;
    const double end = timing_end(sim);
    const double(*mean)[3] = mean_change(sim);
    int broken = 0;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < count; i++)
        vector_add_scaled(sim->state.v[i], 1, mean[i], sim->step.v_next[i]);
    const int unknown = sim->step.out_of_memory ||
                        ((BUILT_WITH(EFFECT_CONTACT) || BUILT_WITH(EFFECT_SELF_COLLISION)) &&
                         resolve_contacts(sim) != 0);
#pragma omp parallel for schedule(static) reduction(max : broken)
    for (int i = 0; i < count; i++) {
        vector_add_scaled(sim->state.x[i], sim->step.h, sim->step.v_next[i], sim->step.x_next[i]);
        for (int a = 0; a < 3; a++)
            if (!isfinite(sim->step.x_next[i][a]) || !isfinite(sim->step.v_next[i][a]))
                broken = 1;
    }
    if (sim->integrator.kind == INTEGRATOR_MIDPOINT || sim->integrator.two_states)
        end_velocity(sim, mean);
    if (BUILT_WITH(EFFECT_PINS))
        collisions_place_pins(&sim->collisions, end, sim->step.x_next, sim->step.v_next);
    return !broken && !unknown;
}

void integrator_accept(simulation *sim) {
    integrator_memory *of = &sim->integrator;
    const size_t count = (size_t)sim->mesh->vertex_count;
    if (of->kind != INTEGRATOR_BDF2)
        return;
    memcpy(of->x_before, sim->state.x, sizeof *sim->state.x * count);
    memcpy(of->v_before, sim->state.v, sizeof *sim->state.v * count);
    of->h_before = has_contact(sim) ? 0 : sim->step.h;
}
