/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Integration in time: backward Euler, linearised at the state the step starts from (Baraff and
 * Witkin 1998).
 */
#include "integrator.h"

#include "forces.h"
#include "simulation_state.h"
#include "vector.h"

/* A contact not foreseen is added and the system solved again, this many times in a step. */
enum { most_solutions = 3 };

static const double (*read_only(double (*a)[3]))[3] {
    return (const double(*)[3])a;
}

void evaluateForces(simulation *sim) {
    sim->h = ticks_to_seconds(sim, sim->ticks);
    const expansion start = {sim->h, read_only(sim->x), read_only(sim->v), read_only(sim->v)};
    forces_assemble(sim, &start);
}

void solveSystem(simulation *sim) {
    const double fall = vector_length(sim->scene->gravity) * sim->h;
    const solver_limits limits = {
        .tolerance = sim->scene->tolerance,
        /* At rest b is nearly 0: what gravity does in a step is the scale of what matters. */
        .floor = 1e-3 * sim->scene->tolerance * fall * sqrt(sim->total_mass),
        .max_iterations = sim->scene->max_iterations,
    };
    for (int n = 0; n < most_solutions; n++) {
        sim->solver_status = solver_solve(&sim->solver, &sim->system, &sim->constraints, &limits,
                                          sim->dv, &sim->iterations);
        if (sim->solver_status != SOLVER_CONVERGED || n + 1 == most_solutions ||
            collisions_add_missed(&sim->collisions, simulation_time(sim), sim->h, read_only(sim->x),
                                  read_only(sim->v), read_only(sim->dv)) == 0)
            return;
        collisions_constrain(&sim->collisions, read_only(sim->v), &sim->constraints);
    }
}

int integrator_move(simulation *sim) {
    const int count = sim->mesh->vertex_count;
    const double end = time_at_tick(sim, sim->ticks_done + sim->ticks);
    int broken = 0;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < count; i++)
        vector_add_scaled(sim->v[i], 1, sim->dv[i], sim->v_next[i]);
    collisions_keep_out(&sim->collisions, simulation_time(sim), sim->h, read_only(sim->x),
                        sim->v_next);
#pragma omp parallel for schedule(static) reduction(max : broken)
    for (int i = 0; i < count; i++) {
        vector_add_scaled(sim->x[i], sim->h, sim->v_next[i], sim->x_next[i]);
        for (int a = 0; a < 3; a++)
            if (!isfinite(sim->x_next[i][a]) || !isfinite(sim->v_next[i][a]))
                broken = 1;
    }
    collisions_place_pins(&sim->collisions, end, sim->x_next, sim->v_next);
    return !broken;
}
