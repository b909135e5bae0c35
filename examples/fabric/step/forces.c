/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "forces.h"

#include "base/clock.h"
#include "simulation_state.h"

static void visit(simulation *sim, int effect) {
    if (effect_is_on(sim, effect))
        sim->account.effects[effect].visited += sim->account.effects[effect].elements;
}

static void add_triangle_forces(simulation *sim, const triangle_material *material,
                                const expansion *at) {
    const double start = clock_seconds();
    triangle_forces(&sim->cloth.triangles, material, at->h, at->x, at->lag, &sim->system);
    /* One loop computes both effects: if both are active, each is charged half its time. */
    const double seconds = clock_seconds() - start;
    const int stretch =
        effect_is_on(sim, EFFECT_STRETCH) || effect_is_on(sim, EFFECT_STRETCH_DAMPING);
    const int shear = effect_is_on(sim, EFFECT_SHEAR) || effect_is_on(sim, EFFECT_SHEAR_DAMPING);
    for (int effect = EFFECT_STRETCH; effect <= EFFECT_SHEAR_DAMPING; effect++)
        if (effect != EFFECT_BEND)
            visit(sim, effect);
    sim->account.effects[EFFECT_STRETCH].seconds +=
        stretch && shear ? seconds / 2 : stretch * seconds;
    sim->account.effects[EFFECT_SHEAR].seconds += stretch && shear ? seconds / 2 : shear * seconds;
}

static void add_strain_limit(simulation *sim, const expansion *at) {
    effect_account *account = &sim->account.effects[EFFECT_STRAIN_LIMIT];
    const double start = clock_seconds();
    strain_limit_forces(&sim->cloth.strain_limit, &sim->cloth.triangles, at->h, at->x, at->lag,
                        &sim->system);
    account->visited += sim->cloth.strain_limit.count;
    account->seconds += clock_seconds() - start;
}

int forces_add_missed(simulation *sim, const expansion *at, const double (*dv)[3]) {
    if (!effect_is_on(sim, EFFECT_STRAIN_LIMIT) ||
        strain_limit_find_missed(&sim->cloth.strain_limit, &sim->cloth.triangles, at->h, at->x,
                                 at->v, dv) == 0)
        return 0;
    add_strain_limit(sim, at);
    return sim->cloth.strain_limit.count;
}

static void add_hinge_forces(simulation *sim, const hinge_material *material, const expansion *at) {
    const double start = clock_seconds();
    hinge_update_angles(&sim->cloth.hinges, at->x);
    hinge_forces(&sim->cloth.hinges, material, at->h, at->x, at->lag, &sim->system);
    visit(sim, EFFECT_BEND);
    visit(sim, EFFECT_BEND_DAMPING);
    sim->account.effects[EFFECT_BEND].seconds += clock_seconds() - start;
}

static void add_outer(simulation *sim, int effect, const outer_force *force, const expansion *at) {
    const force_target on = {&sim->scene->surroundings, &sim->cloth.triangles, sim->in_force.wind};
    const double start = clock_seconds();
    force->add(&on, at, &sim->system);
    visit(sim, effect);
    sim->account.effects[effect].seconds += clock_seconds() - start;
}

static void add_outer_forces(simulation *sim, const expansion *at) {
#define OUTER_FORCE(NAME, name)                                                                    \
    if (effect_is_on(sim, EFFECT_##NAME))                                                          \
        add_outer(sim, EFFECT_##NAME, &outer_force_##name, at);
#include "effects/effects.def"
    if (effect_is_on(sim, EFFECT_DRAG))
        visit(sim, EFFECT_WIND); /* wind acts through drag */
}

static void add_masses(simulation *sim, double h) {
    const double start = clock_seconds();
    system_reset(&sim->system, sim->cloth.mass, sim->scene->surroundings.gravity, h);
    visit(sim, EFFECT_GRAVITY);
    sim->account.effects[EFFECT_GRAVITY].seconds += clock_seconds() - start;
}

static void add_elements(simulation *sim, const triangle_material *triangle,
                         const hinge_material *hinge, const expansion *at) {
    if (sim->cloth.has_triangle_forces && (BUILT_WITH(EFFECT_STRETCH) || BUILT_WITH(EFFECT_SHEAR)))
        add_triangle_forces(sim, triangle, at);
    if (sim->cloth.has_hinge_forces && BUILT_WITH(EFFECT_BEND))
        add_hinge_forces(sim, hinge, at);
}

static void add_limit(simulation *sim, const expansion *at) {
    if (!effect_is_on(sim, EFFECT_STRAIN_LIMIT))
        return;
    strain_limit_find(&sim->cloth.strain_limit, &sim->cloth.triangles, at->x);
    add_strain_limit(sim, at);
}

void forces_assemble(simulation *sim, const expansion *at) {
    add_masses(sim, at->h);
    add_elements(sim, &sim->cloth.triangle_material, &sim->cloth.hinge_material, at);
    add_limit(sim, at);
    add_outer_forces(sim, at);
}

void forces_assemble_lagged(simulation *sim, const expansion *at) {
    const triangle_material triangle = {
        .stretch_damping = sim->cloth.triangle_material.stretch_damping,
        .shear_damping = sim->cloth.triangle_material.shear_damping};
    const hinge_material hinge = {.bend_damping = sim->cloth.hinge_material.bend_damping};
    add_masses(sim, at->h);
    add_elements(sim, &triangle, &hinge, at);
    add_outer_forces(sim, at);
}

void forces_add_elastic(simulation *sim, const expansion *at) {
    const triangle_material triangle = {.stretch = sim->cloth.triangle_material.stretch,
                                        .shear = sim->cloth.triangle_material.shear};
    const hinge_material hinge = {.bend = sim->cloth.hinge_material.bend};
    add_elements(sim, &triangle, &hinge, at);
    add_limit(sim, at);
}
