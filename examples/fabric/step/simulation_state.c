/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Creates, frees and inspects a simulation; simulation.c runs it. */
#include "simulation_state.h"

#include "solver/solver_direct.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "barrier_step.h"
#include "base/vector.h"

/* Adds a third of each triangle's mass to each of its vertices. */
static void share_mass(simulation *sim) {
    for (int t = 0; t < sim->cloth.triangles.count; t++)
        for (int p = 0; p < 3; p++)
            sim->cloth.mass[sim->cloth.triangles.vertex[t][p]] +=
                sim->scene->material.density * sim->cloth.triangles.rest[t].area / 3;
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        sim->cloth.total_mass += sim->cloth.mass[i];
}

/* Lays out A. Only elements with a force couple vertices. */
static int lay_out_system(simulation *sim) {
    element_list lists[2];
    int count = 0;
    if (sim->cloth.has_triangle_forces)
        lists[count++] =
            (element_list){sim->cloth.triangles.count, 3, &sim->cloth.triangles.vertex[0][0]};
    if (sim->cloth.has_hinge_forces)
        lists[count++] =
            (element_list){sim->cloth.hinges.count, 4, &sim->cloth.hinges.vertex[0][0]};
    if (system_init(&sim->system, sim->mesh->vertex_count, count, lists) != 0)
        return -1;
    if (sim->cloth.has_triangle_forces &&
        triangle_elements_place(&sim->cloth.triangles, &sim->system.A) != 0)
        return -1;
    return sim->cloth.has_hinge_forces ? hinge_elements_place(&sim->cloth.hinges, &sim->system.A)
                                       : 0;
}

static int allocate_state(simulation *sim) {
    const size_t n = (size_t)sim->mesh->vertex_count + 1;
    double(**const vectors[])[3] = {&sim->state.x, &sim->state.v,     &sim->step.guess,
                                    &sim->step.dv, &sim->step.x_next, &sim->step.v_next};
    sim->cloth.mass = arrays_add(&sim->own, n, sizeof *sim->cloth.mass);
    for (size_t k = 0; k < sizeof vectors / sizeof *vectors; k++)
        *vectors[k] = arrays_add(&sim->own, n, sizeof(double[3]));
    return sim->own.failed ? -1 : 0;
}

/* The cloth starts at rest except for moving pins; the first guess is free fall. */
static void set_start(simulation *sim) {
    const scene *s = sim->scene;
    memcpy(sim->state.x, sim->mesh->position,
           sizeof *sim->state.x * (size_t)sim->mesh->vertex_count);
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            sim->step.guess[i][a] = s->time.step * s->surroundings.gravity[a];
    collisions_place_pins(&sim->collisions, 0, sim->state.x, sim->state.v);
    sim->step.ticks = TICKS_PER_STEP;
    sim->step.h = sim->step.stage_h = s->time.step;
    sim->step.guess_h = s->time.step;
}

static void start_monitor(simulation *sim) {
    hinge_update_angles(&sim->cloth.hinges, (const double(*)[3])sim->state.x);
    const monitored_step start = simulation_monitored(sim);
    monitor_begin(&sim->monitor, sim->scene, &start);
}

/* Rejects settings that the barrier's Newton method does not support. */
static int check_barrier(const scene *s, char *error) {
    const char *wrong = NULL;
    if (s->time.integrator != INTEGRATOR_LINEAR_EULER && s->time.integrator != INTEGRATOR_EULER)
        wrong = "time.integrator is euler: backward Euler, by Newton's method";
    else if (s->solution.method != METHOD_CONJUGATE_GRADIENTS)
        wrong = "solution.method is conjugate-gradients";
    else if (s->solution.precision != PRECISION_DOUBLE)
        wrong = "solution.precision is double";
    if (wrong)
        snprintf(error, 200, "with 'contact: barrier' %s", wrong);
    return wrong ? -1 : 0;
}

static int build(simulation *sim, char *error) {
    const scene *s = sim->scene;
    const int by_barrier = s->contact.method == CONTACT_BARRIER;
    if (!by_barrier && s->contact.untangle) {
        snprintf(error, 200, "'contact.untangle: on' needs 'contact.method: barrier'");
        return -1;
    }
    if (by_barrier && check_barrier(s, error) != 0)
        return -1;
    const integrator_kind integrator =
        by_barrier ? INTEGRATOR_LINEAR_EULER : (integrator_kind)s->time.integrator;
    solver_options options = {
        (preconditioner_kind)s->solution.preconditioner, (solver_precision)s->solution.precision,
        (solver_method)s->solution.method, integrator != INTEGRATOR_LINEAR_EULER};
    if (by_barrier) /* the barrier's matrix changes its layout in each iteration: use a solver
                     * without a fixed one */
        options = (solver_options){.preconditioner = PRECONDITIONER_BLOCK_JACOBI};
    const int vertices = sim->mesh->vertex_count;
    sim->cloth.triangle_material =
        (triangle_material){s->material.stretch, s->material.shear, s->material.stretch_damping,
                            s->material.shear_damping};
    sim->cloth.hinge_material = (hinge_material){s->material.bend, s->material.bend_damping};
    sim->cloth.has_triangle_forces = s->material.stretch > 0 || s->material.shear > 0 ||
                                     s->material.stretch_damping > 0 ||
                                     s->material.shear_damping > 0;
    sim->cloth.has_hinge_forces = s->material.bend > 0 || s->material.bend_damping > 0;
    if (allocate_state(sim) != 0 || triangle_elements_init(&sim->cloth.triangles, sim->mesh) != 0 ||
        (s->material.strain_limit > 0 &&
         strain_limit_init(&sim->cloth.strain_limit, &sim->cloth.triangles,
                           s->material.strain_limit, s->material.stretch) != 0) ||
        (sim->cloth.has_hinge_forces && hinge_elements_init(&sim->cloth.hinges, sim->mesh) != 0) ||
        (s->material.bend > 0 && !s->monitor.off &&
         hinge_elements_cache_angles(&sim->cloth.hinges) != 0))
        return -1;
    share_mass(sim);
    if (lay_out_system(sim) != 0 || constraints_init(&sim->constraints, vertices) != 0 ||
        solver_init(&sim->solver, vertices) != 0 ||
        solver_choose(&sim->solver, &sim->system.A, &options, error) != 0 ||
        integrator_init(&sim->integrator, integrator, vertices) != 0 ||
        collisions_init(&sim->collisions, sim->mesh, s, sim->cloth.mass) != 0)
        return -1;
    if (!by_barrier && s->self_collision.gap > 0 &&
        self_collision_init(&sim->self_collision, sim->mesh, s->self_collision.gap,
                            s->self_collision.friction, s->time.step) != 0)
        return -1;
    plan_make(sim);
    if (by_barrier)
        sim->collisions.any_near = 0; /* the barrier keeps vertices out of bodies */
    set_start(sim);
    if (by_barrier && barrier_step_init(sim, error) != 0)
        return -1;
    start_monitor(sim);
    return 0;
}

static int all_finite(const mesh *m) {
    for (int i = 0; i < m->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            if (!isfinite(m->position[i][a]) || (a < 2 && !isfinite(m->material[i][a])))
                return 0;
    return 1;
}

simulation *simulation_new(const mesh *m, const scene *s, char *error) {
    char reason[256] = "out of memory";
    simulation *sim = NULL;
    if (!all_finite(m))
        snprintf(reason, sizeof reason, "a position is not finite");
    else
        sim = calloc(1, sizeof *sim);
    if (sim) {
        sim->mesh = m;
        sim->scene = s;
        if (build(sim, reason) == 0) {
            if (isfinite(sim->monitor.energy) && isfinite(sim->cloth.total_mass))
                return sim;
            snprintf(reason, sizeof reason, "their mass or energy is not finite");
        }
    }
    simulation_free(sim);
    snprintf(error, 256, "cannot simulate %d vertices: %.200s", m->vertex_count, reason);
    return NULL;
}

void simulation_make_room(simulation *sim) {
    if (!sim->barrier && sim->account.effects[EFFECT_SELF_COLLISION].active)
        self_collision_find(&sim->self_collision, sim->scene->time.step,
                            (const double(*)[3])sim->state.x, (const double(*)[3])sim->step.guess);
}

double simulation_direct_bytes(const simulation *sim, int *only) {
    char error[256];
    double held = 0, more = 0;
    *only = sim->solver.direct != NULL;
    if (*only) {
        direct_solver_memory(sim->solver.direct, &held, &more);
        return more;
    }
    direct_solver *d = direct_solver_available() ? direct_solver_new(&sim->system.A, error) : NULL;
    if (d)
        direct_solver_memory(d, &held, &more);
    direct_solver_free(d);
    return held + more;
}

void simulation_free(simulation *sim) {
    if (!sim)
        return;
    triangle_elements_free(&sim->cloth.triangles);
    hinge_elements_free(&sim->cloth.hinges);
    strain_limit_free(&sim->cloth.strain_limit);
    system_free(&sim->system);
    collisions_free(&sim->collisions);
    constraints_free(&sim->constraints);
    self_collision_free(&sim->self_collision);
    solver_free(&sim->solver);
    solver_fallback_free(&sim->fallback);
    barrier_step_free(sim);
    integrator_free(&sim->integrator);
    arrays_free(&sim->own);
    free(sim->account.rejections);
    free(sim->kept);
    free(sim);
}

const double (*simulation_positions(const simulation *sim))[3] {
    return (const double(*)[3])sim->state.x;
}

const double (*simulation_velocities(const simulation *sim))[3] {
    return (const double(*)[3])sim->state.v;
}

double simulation_time(const simulation *sim) {
    return time_at_tick(sim, sim->state.ticks_done) + sim->state.part;
}

const phase *simulation_phases(const simulation *sim) {
    return sim->account.phases;
}

const effect_account *simulation_effects(const simulation *sim, int *count) {
    *count = EFFECT_COUNT;
    return sim->account.effects;
}

run_counts simulation_counts(const simulation *sim) {
    const struct run_account *a = &sim->account;
    return (run_counts){a->iterations,  sim->integrator.iterations,
                        a->steps_taken, a->steps_rejected,
                        a->steps_slept, sim->system.A.block_count};
}

int simulation_log_rejections(simulation *sim) {
    if (!sim->account.rejections)
        sim->account.rejections = calloc(MOST_REJECTIONS, sizeof *sim->account.rejections);
    return sim->account.rejections ? 0 : -1;
}

const rejection *simulation_rejections(const simulation *sim, int *count) {
    *count = simulation_rejections_logged(sim);
    return sim->account.rejections;
}

run_faults simulation_faults(const simulation *sim) {
    const monitor *m = &sim->monitor;
    return (run_faults){
        .not_solved = m->let_pass[STEP_NOT_SOLVED],
        .strain = m->let_pass[STEP_STRAIN],
        .penetration = m->let_pass[STEP_PENETRATION],
        .passing = m->let_pass[STEP_PASSING],
        .greatest_strain = m->greatest_strain,
        .strain_limit = m->scene->monitor.strain,
        .deepest = m->deepest,
        .start_inside = m->start_inside,
        .start_depth = m->start_depth,
        .watched = sim->account.effects[EFFECT_MONITOR].active,
        .solved_directly = sim->fallback.solved,
    };
}
