/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* See integrator.h for the methods. */
#include "integrator.h"

#include <stdlib.h>
#include <string.h>

#include "clock.h"
#include "forces.h"
#include "impact.h"
#include "newton.h"
#include "simulation_state.h"
#include "vector.h"

/* A contact not foreseen is added and the system solved again, this many times in a step. */
enum { most_solutions = 3 };

static const double (*read_only(double (*a)[3]))[3] {
    return (const double(*)[3])a;
}

static double (*new_vectors(int count))[3] {
    return calloc((size_t)count + 1, sizeof(double[3]));
}

int integrator_init(integrator_memory *memory, integrator_kind kind, int vertex_count) {
    *memory = (integrator_memory){.kind = kind};
    if (kind == INTEGRATOR_LINEAR_EULER)
        return 0;
    double(**const arrays[])[3] = {&memory->base_x,      &memory->base_v,   &memory->at_x,
                                   &memory->at_v,        &memory->lag,      &memory->last,
                                   &memory->last_defect, &memory->x_before, &memory->v_before};
    const int count = kind == INTEGRATOR_BDF2 ? 9 : 7;
    for (int k = 0; k < count; k++) {
        *arrays[k] = new_vectors(vertex_count);
        if (!*arrays[k]) {
            integrator_free(memory);
            return -1;
        }
    }
    return 0;
}

void integrator_free(integrator_memory *memory) {
    free(memory->x_before);
    free(memory->v_before);
    free(memory->base_x);
    free(memory->base_v);
    free(memory->at_x);
    free(memory->at_v);
    free(memory->lag);
    free(memory->last);
    free(memory->last_defect);
    *memory = (integrator_memory){0};
}

/* X, V and tau of the step under way; BDF2 rests on two states where there are two. */
static void set_stage(simulation *sim, int two_states) {
    integrator_memory *of = &sim->integrator;
    const double ratio = two_states ? sim->h / of->h_before : 0;
    const double newer = (1 + ratio) * (1 + ratio) / (1 + 2 * ratio);
    const double older = ratio * ratio / (1 + 2 * ratio);
    of->two_states = two_states;
    sim->stage_h = of->kind == INTEGRATOR_MIDPOINT ? sim->h / 2
                   : two_states                    ? (1 + ratio) / (1 + 2 * ratio) * sim->h
                                                   : sim->h;
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++) {
            of->base_x[i][a] = sim->x[i][a];
            of->base_v[i][a] = sim->v[i][a];
            if (two_states) {
                of->base_x[i][a] = newer * sim->x[i][a] - older * of->x_before[i][a];
                of->base_v[i][a] = newer * sim->v[i][a] - older * of->v_before[i][a];
            }
        }
}

void evaluateForces(simulation *sim) {
    sim->h = ticks_to_seconds(sim, sim->ticks);
    if (sim->integrator.kind == INTEGRATOR_LINEAR_EULER) {
        const expansion start = {sim->h, read_only(sim->x), read_only(sim->v), read_only(sim->v)};
        sim->stage_h = sim->h;
        forces_assemble(sim, &start);
        return;
    }
    set_stage(sim, sim->integrator.kind == INTEGRATOR_BDF2 && sim->integrator.h_before > 0);
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

/* A contact breaks the smoothness that BDF2 lives on, and where the two states before would put a
 * vertex may lie behind a thin collider: such a step is backward Euler's. */
static void leave_two_states(simulation *sim) {
    set_stage(sim, 0);
    newton_assemble_at_base(sim);
    collisions_add_friction(&sim->collisions, sim->stage_h, read_only(sim->v), &sim->system);
}

/* x = X + tau (v + dv) as a change of the mean velocity over the step: what contacts go by. */
static const double (*travel(simulation *sim))[3] {
    const integrator_memory *of = &sim->integrator;
    if (!of->two_states)
        return read_only(sim->dv);
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            of->last[i][a] =
                (of->base_x[i][a] - sim->x[i][a] + sim->stage_h * (sim->v[i][a] + sim->dv[i][a])) /
                    sim->h -
                sim->v[i][a];
    return read_only(of->last);
}

static solver_status solve_stage(simulation *sim) {
    if (sim->integrator.kind != INTEGRATOR_LINEAR_EULER)
        return newton_solve(sim);
    const double fall = vector_length(sim->scene->gravity) * sim->h;
    const solver_limits limits = {
        .tolerance = sim->scene->tolerance,
        /* At rest b is nearly 0: what gravity does in a step is the scale of what matters. */
        .floor = 1e-3 * sim->scene->tolerance * fall * sqrt(sim->total_mass),
        .max_iterations = sim->scene->max_iterations,
    };
    return solver_fallback_solve(&sim->fallback, &sim->solver, &sim->system, &sim->constraints,
                                 &limits, sim->dv, &sim->iterations);
}

/* Newton's method finds such forces by itself, at the states it goes through. */
static int add_missed_forces(simulation *sim) {
    const expansion start = {sim->h, read_only(sim->x), read_only(sim->v), read_only(sim->v)};
    if (sim->integrator.kind != INTEGRATOR_LINEAR_EULER)
        return 0;
    return forces_add_missed(sim, &start, read_only(sim->dv));
}

void solveSystem(simulation *sim) {
    if (sim->integrator.two_states && has_contact(sim))
        leave_two_states(sim);
    for (int n = 0; n < most_solutions; n++) {
        sim->solver_status = solve_stage(sim);
        if (sim->solver_status != SOLVER_CONVERGED || n + 1 == most_solutions)
            return;
        const int contacts =
            BUILT_WITH(EFFECT_CONTACT) == 0
                ? 0
                : collisions_add_missed(&sim->collisions, simulation_time(sim), sim->h,
                                        read_only(sim->x), read_only(sim->v), travel(sim));
        if (add_missed_forces(sim) == 0 && contacts == 0)
            return;
        if (contacts == 0)
            continue;
        if (collisions_constrain(&sim->collisions, read_only(sim->v), &sim->constraints) != 0)
            sim->out_of_memory = 1;
        if (sim->integrator.kind != INTEGRATOR_LINEAR_EULER)
            leave_two_states(sim);
    }
}

/* v_next, which so far is the mean velocity over the step, becomes the one at its end. */
static void end_velocity(simulation *sim, const double (*mean)[3]) {
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++) {
            const double pushed = sim->v_next[i][a] - (sim->v[i][a] + mean[i][a]);
            sim->v_next[i][a] = sim->v[i][a] + sim->dv[i][a] + pushed;
            /* The midpoint's change doubles, but along given directions: contact does not bounce.
             */
            if (sim->integrator.kind == INTEGRATOR_MIDPOINT)
                sim->v_next[i][a] +=
                    vector_dot(constraint_projection(&sim->constraints, i)[a], sim->dv[i]);
        }
}

/* Changes v_next so that the cloth goes through neither itself nor a body. 0, or -1: that could not
 * be found out. */
static int keep_apart(simulation *sim) {
    const int itself = effect_is_on(sim, EFFECT_SELF_COLLISION);
    effect_account *account = &sim->effects[EFFECT_SELF_COLLISION];
    const double start = clock_seconds();
    impact_step step = {
        .time = simulation_time(sim),
        .h = sim->h,
        .x = read_only(sim->x),
        .v = sim->v_next,
        .of = {sim->mass, &sim->collisions},
        .itself = itself ? &sim->self_collision : NULL,
        .bodies = &sim->collisions,
    };
    const int status = impact_resolve(&step, &sim->push_work);
    if (itself) {
        account->visited = sim->self_collision.visits;
        account->seconds += clock_seconds() - start;
    }
    return status;
}

int integrator_move(simulation *sim) {
    const int count = sim->mesh->vertex_count;
    const double end = time_at_tick(sim, sim->ticks_done + sim->ticks);
    const double(*mean)[3] = travel(sim);
    int broken = 0;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < count; i++)
        vector_add_scaled(sim->v[i], 1, mean[i], sim->v_next[i]);
    const int unknown =
        sim->out_of_memory ||
        ((BUILT_WITH(EFFECT_CONTACT) || BUILT_WITH(EFFECT_SELF_COLLISION)) && keep_apart(sim) != 0);
#pragma omp parallel for schedule(static) reduction(max : broken)
    for (int i = 0; i < count; i++) {
        vector_add_scaled(sim->x[i], sim->h, sim->v_next[i], sim->x_next[i]);
        for (int a = 0; a < 3; a++)
            if (!isfinite(sim->x_next[i][a]) || !isfinite(sim->v_next[i][a]))
                broken = 1;
    }
    if (sim->integrator.kind == INTEGRATOR_MIDPOINT || sim->integrator.two_states)
        end_velocity(sim, mean);
    if (BUILT_WITH(EFFECT_PINS))
        collisions_place_pins(&sim->collisions, end, sim->x_next, sim->v_next);
    return !broken && !unknown;
}

void integrator_accept(simulation *sim) {
    integrator_memory *of = &sim->integrator;
    const size_t count = (size_t)sim->mesh->vertex_count;
    if (of->kind != INTEGRATOR_BDF2)
        return;
    memcpy(of->x_before, sim->x, sizeof *sim->x * count);
    memcpy(of->v_before, sim->v, sizeof *sim->v * count);
    of->h_before = has_contact(sim) ? 0 : sim->h;
}
