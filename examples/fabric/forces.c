/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "forces.h"

#include "clock.h"
#include "effects/drag.h"
#include "simulation_state.h"

static void add_triangle_forces(simulation *sim, const expansion *at) {
    const double start = clock_seconds();
    triangle_forces(&sim->triangles, &sim->triangle_material, at->h, at->x, at->lag, &sim->system);
    /* One loop makes both: where both are active each is charged half. */
    const double seconds = clock_seconds() - start;
    const int both = sim->effects[EFFECT_STRETCH].active && sim->effects[EFFECT_SHEAR].active;
    if (!sim->effects[EFFECT_SHEAR].active || both)
        sim->effects[EFFECT_STRETCH].seconds += both ? seconds / 2 : seconds;
    if (sim->effects[EFFECT_SHEAR].active)
        sim->effects[EFFECT_SHEAR].seconds += both ? seconds / 2 : seconds;
}

static void add_hinge_forces(simulation *sim, const expansion *at) {
    const double start = clock_seconds();
    hinge_update_angles(&sim->hinges, at->x);
    hinge_forces(&sim->hinges, &sim->hinge_material, at->h, at->x, at->lag, &sim->system);
    sim->effects[EFFECT_BEND].seconds += clock_seconds() - start;
}

static void add_drag(simulation *sim, const expansion *at) {
    const double start = clock_seconds();
    drag_forces(&sim->triangles, sim->scene->drag, sim->scene->wind, at->h, at->x, at->v,
                &sim->system);
    sim->effects[EFFECT_DRAG].seconds += clock_seconds() - start;
}

void forces_assemble(simulation *sim, const expansion *at) {
    const double start = clock_seconds();
    system_reset(&sim->system, sim->mass, sim->scene->gravity, at->h);
    sim->effects[EFFECT_GRAVITY].seconds += clock_seconds() - start;
    if (sim->has_triangle_forces)
        add_triangle_forces(sim, at);
    if (sim->has_hinge_forces)
        add_hinge_forces(sim, at);
    if (sim->effects[EFFECT_DRAG].active)
        add_drag(sim, at);
}
