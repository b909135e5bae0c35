/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * The loop of figure 2 of the paper. A step that fails - no solution, or a cloth that is torn apart
 * - is taken again at half the length; lengths are the scene's step over powers of two, so every
 * frame ends on the scene's grid of times.
 */
#include "simulation.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "clock.h"
#include "integrator.h"
#include "simulation_state.h"

/* A step may stretch no triangle by more than this part of its rest length, unless it ends below
 * the second. */
static const double greatest_growth = 0.5;
static const double harmless_strain = 1;
/* After this many steps in a row without trouble a halved length is doubled. */
enum { steps_before_growth = 3 };

static const double (*read_only(double (*a)[3]))[3] {
    return (const double(*)[3])a;
}

void collisionDetection(simulation *sim) {
    const double start = clock_seconds();
    const double scale = sim->h / sim->guess_h;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            sim->dv[i][a] = scale * sim->guess[i][a];
    collisions_detect(&sim->collisions, simulation_time(sim), sim->h, read_only(sim->x),
                      read_only(sim->v), read_only(sim->dv));
    collisions_add_friction(&sim->collisions, sim->stage_h, read_only(sim->v), &sim->system);
    collisions_constrain(&sim->collisions, read_only(sim->v), &sim->constraints);
    sim->effects[EFFECT_CONTACT].seconds += clock_seconds() - start;
}

/* The step ends in a state the cloth may be in. At the shortest length anything finite will do. */
static int acceptable(const simulation *sim, int finite, double strain) {
    if (!finite || !isfinite(strain))
        return 0;
    if (sim->ticks == 1)
        return 1;
    return sim->solver_status == SOLVER_CONVERGED &&
           (strain < harmless_strain || strain - sim->strain < greatest_growth);
}

static void accept(simulation *sim, double strain) {
    const size_t count = (size_t)sim->mesh->vertex_count;
    collisions_accept(&sim->collisions, sim->stage_h, sim->mass, read_only(sim->v_next),
                      read_only(sim->solver.residual));
    integrator_accept(sim);
    memcpy(sim->x, sim->x_next, sizeof *sim->x * count);
    memcpy(sim->v, sim->v_next, sizeof *sim->v * count);
    memcpy(sim->guess, sim->dv, sizeof *sim->guess * count);
    sim->guess_h = sim->h;
    sim->strain = strain;
    sim->steps_taken++;
    sim->easy_steps++;
    sim->ticks_done += sim->ticks;
    if (sim->easy_steps >= steps_before_growth && sim->ticks < TICKS_PER_STEP &&
        sim->ticks_done % (2 * sim->ticks) == 0) {
        sim->ticks *= 2;
        sim->easy_steps = 0;
    }
    if (sim->ticks_done == TICKS_PER_STEP) {
        sim->ticks_done = 0;
        sim->frame++;
    }
}

static void reject(simulation *sim) {
    sim->steps_rejected++;
    sim->easy_steps = 0;
    if (sim->ticks > 1)
        sim->ticks /= 2;
}

void updateSystem(simulation *sim) {
    const int finite = integrator_move(sim);
    const double strain = triangle_greatest_strain(&sim->triangles, read_only(sim->x_next));
    sim->accepted = acceptable(sim, finite, strain);
    if (sim->accepted)
        accept(sim, strain);
    else
        reject(sim);
}

static void run_phase(simulation *sim, int index, void (*run)(simulation *)) {
    const double start = clock_seconds();
    run(sim);
    sim->phases[index].seconds += clock_seconds() - start;
    sim->phases[index].calls++;
}

int simulation_step(simulation *sim, char *error) {
    const long frame = sim->frame;
    while (sim->frame == frame) {
        const int shortest = sim->ticks == 1;
        run_phase(sim, PHASE_FORCES, evaluateForces);
        run_phase(sim, PHASE_COLLISIONS, collisionDetection);
        run_phase(sim, PHASE_SOLVE, solveSystem);
        run_phase(sim, PHASE_UPDATE, updateSystem);
        if (!sim->accepted && shortest) {
            snprintf(error, 256, "no finite state after %g s, even in steps of %g s",
                     simulation_time(sim), sim->h);
            return -1;
        }
    }
    return 0;
}
