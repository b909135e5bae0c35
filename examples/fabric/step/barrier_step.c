/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "barrier_step.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/chunk_sum.h"
#include "base/clock.h"
#include "base/vector.h"
#include "forces.h"
#include "simulation_state.h"
#include "timing.h"

/* Newton's method ends when no vertex moves by more than this fraction of the least reach. */
static const double still_part = 1e-3;
/* Largest displacement in an iteration, in mean edge lengths, so that swept boxes stay small. */
static const double most_edges = 2;
/* Pairs are searched along this multiple of Newton's displacement. */
static const double most_stretch = 4;
enum { most_halvings = 40, most_drives = 60, most_iterations = 300 };

void barrier_step_free(simulation *sim) {
    barrier_step *s = sim->barrier;
    if (!s)
        return;
    barrier_free(&s->contact);
    barrier_system_free(&s->system);
    arrays_free(&s->own);
    free(s);
    sim->barrier = NULL;
}

static int allocate(simulation *sim) {
    barrier_step *s = sim->barrier;
    double(**const vectors[])[3] = {&s->base_b,          &s->dv,     &s->product,
                                    &s->still,           &s->change, &s->descent.direction,
                                    &s->descent.residual};
    s->base = arrays_add(&s->own, (size_t)sim->system.A.block_count + 1, sizeof *s->base);
    s->trial = arrays_add(&s->own, (size_t)s->contact.surface.vertex_count + 1, sizeof *s->trial);
    for (size_t k = 0; k < sizeof vectors / sizeof *vectors; k++)
        *vectors[k] = arrays_add(&s->own, (size_t)sim->mesh->vertex_count + 1, sizeof(double[3]));
    return s->own.failed ? -1 : 0;
}

/* Finds the driven vertices, and their positions at the step's end, at time `end`. */
static void set_goals(simulation *sim, double end) {
    barrier *b = &sim->barrier->contact;
    const int vertices = sim->mesh->vertex_count;
    for (int i = 0; i < b->surface.vertex_count; i++)
        b->driven[i] = i >= vertices || collisions_pin_of(&sim->collisions, i) >= 0;
    memcpy(b->goal, b->x, (size_t)b->surface.vertex_count * sizeof *b->goal);
    barrier_place_bodies(b, end, b->goal);
    collisions_place_pins(&sim->collisions, end, b->goal, sim->barrier->change);
}

/* Sets the surface's positions to those at the step's beginning. */
static void set_begin(simulation *sim) {
    barrier *b = &sim->barrier->contact;
    memcpy(b->begin, sim->state.x, (size_t)sim->mesh->vertex_count * sizeof *b->begin);
    barrier_place_bodies(b, simulation_time(sim), b->begin);
    memcpy(b->x, b->begin, (size_t)b->surface.vertex_count * sizeof *b->x);
}

static double least_reach(const scene *s) {
    double least = s->self_collision.gap > 0 ? s->self_collision.gap : INFINITY;
    for (int n = 0; n < s->collider_count; n++)
        least = fmin(least, s->colliders[n].gap);
    return least;
}

int barrier_step_init(simulation *sim, char *error) {
    const scene *s = sim->scene;
    snprintf(error, 200, "out of memory");
    sim->barrier = calloc(1, sizeof *sim->barrier);
    if (!sim->barrier ||
        barrier_init(&sim->barrier->contact, sim->mesh, s, sim->cloth.mass, error) != 0)
        return -1;
    barrier *b = &sim->barrier->contact;
    snprintf(error, 200, "out of memory");
    if (allocate(sim) != 0 ||
        barrier_system_init(&sim->barrier->system, &sim->system.A, b->surface.vertex_count) != 0)
        return -1;
    sim->barrier->longest_displacement = most_edges * mesh_mean_edge(sim->mesh);
    sim->barrier->still_distance =
        still_part * fmin(least_reach(s), sim->barrier->longest_displacement);
    set_begin(sim);
    set_goals(sim, 0);
    if (s->contact.untangle) {
        if (barrier_untangle(b) != 0)
            return -1;
        memcpy(sim->state.x, b->x, (size_t)sim->mesh->vertex_count * sizeof *b->x);
    }
    if (barrier_find_pairs(b, read_only(b->x), NULL) != 0)
        return -1;
    return barrier_check_start(b, error);
}

void barrier_step_forces(simulation *sim) {
    barrier_step *s = sim->barrier;
    const size_t n = (size_t)sim->mesh->vertex_count;
    timing_begin(sim);
    sim->step.stage_h = sim->step.h;
    const expansion start = {sim->step.h, read_only(sim->state.x), read_only(sim->state.v),
                             read_only(sim->state.v)};
    forces_assemble_lagged(sim, &start);
    memcpy(s->base, sim->system.A.value, (size_t)sim->system.A.block_count * sizeof *s->base);
    memcpy(s->base_b, sim->system.b, n * sizeof *s->base_b);
}

void barrier_step_detect(simulation *sim) {
    barrier_step *s = sim->barrier;
    barrier *b = &s->contact;
    set_begin(sim);
    set_goals(sim, timing_end(sim));
    barrier_begin_search(b);
    sim->step.out_of_memory |= barrier_find_pairs(b, read_only(b->x), NULL) != 0 ||
                               barrier_find_contacts(b, read_only(b->x)) != 0 ||
                               barrier_grip_contacts(b) != 0;
    s->begin_energy = barrier_energy(b, read_only(b->x));
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        if (b->driven[i] && constraint_place(&sim->constraints, i) != 0)
            sim->step.out_of_memory = 1;
}

/* Computes the dv that leads to positions x, and C dv. */
static void set_change(simulation *sim, const double (*x)[3]) {
    barrier_step *s = sim->barrier;
    const double h = sim->step.h;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++) {
            s->dv[i][a] = (x[i][a] - sim->state.x[i][a]) / h - sim->state.v[i][a];
            s->product[i][a] = 0;
        }
    const block_matrix *A = &sim->system.A;
    const block_matrix C = {A->row_count, A->block_count, A->row_start, A->column, s->base};
    half_product(&C, read_only(s->dv), s->product);
}

/* Computes E (barrier_step.h) at positions x, J. */
static double potential(simulation *sim, const double (*x)[3]) {
    const barrier_step *s = sim->barrier;
    double sum[CHUNK_SUM_MOST] = {0}, stretch = 0, shear = 0, elastic = 0;
    const int count = sim->mesh->vertex_count;
    set_change(sim, x);
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        for (int i = chunk * chunk_sum_length(count); i < chunk_sum_end(count, chunk); i++)
            sum[chunk] +=
                vector_dot(s->dv[i], s->product[i]) / 2 - vector_dot(s->dv[i], s->base_b[i]);
    triangle_energies(&sim->cloth.triangles, &sim->cloth.triangle_material, x, &stretch, &shear);
    if (sim->cloth.hinge_material.bend > 0)
        elastic += hinge_energy_at(&sim->cloth.hinges, &sim->cloth.hinge_material, x);
    if (effect_is_on(sim, EFFECT_STRAIN_LIMIT))
        elastic += strain_limit_energy(&sim->cloth.strain_limit, &sim->cloth.triangles, x);
    return chunk_sum_all(count, sum) + stretch + shear + elastic + barrier_energy(&s->contact, x) +
           barrier_friction(&s->contact, sim->step.h, x);
}

/* Assembles the system for the change of dv at b->x while driven vertices move to their goals. */
static int assemble(simulation *sim) {
    barrier_step *s = sim->barrier;
    barrier *b = &s->contact;
    const int vertices = sim->mesh->vertex_count;
    const double h = sim->step.h, begun = clock_seconds();
    set_change(sim, read_only(b->x));
    memcpy(sim->system.A.value, s->base, (size_t)sim->system.A.block_count * sizeof *s->base);
    for (int i = 0; i < vertices; i++)
        vector_subtract(s->base_b[i], s->product[i], sim->system.b[i]);
    const expansion at = {h, read_only(b->x), read_only(s->still), read_only(s->still)};
    forces_add_elastic(sim, &at);
    for (int i = 0; i < b->surface.vertex_count; i++)
        vector_subtract(b->goal[i], b->x[i], b->displacement[i]);
    if (barrier_make_elements(b, h, read_only(b->x)) != 0 ||
        barrier_system_make(&s->system, b, h, &sim->system) != 0)
        return -1;
    static const double all[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < vertices; i++)
        if (b->driven[i]) {
            const double change[3] = {b->displacement[i][0] / h, b->displacement[i][1] / h,
                                      b->displacement[i][2] / h};
            constraint_give(&sim->constraints, i, 3, all, change);
        } else if (sim->constraints.given[i] > 0) {
            constraint_release(&sim->constraints, i);
        }
    const double seconds = clock_seconds() - begun;
    sim->account.phases[PHASE_FORCES].seconds += seconds;
    sim->account.phases[PHASE_SOLVE].seconds -= seconds;
    return 0;
}

/* Computes displacements by the linear system. *most receives the largest displacement of a free
 * vertex, m. */
static solver_status find_displacements(simulation *sim, double *most) {
    barrier_step *s = sim->barrier;
    barrier *b = &s->contact;
    const int vertices = sim->mesh->vertex_count;
    const solver_limits limits = {.tolerance = sim->scene->solution.tolerance,
                                  .max_iterations = sim->scene->solution.max_iterations};
    memset(s->change, 0, (size_t)vertices * sizeof *s->change);
    sim->integrator.iterations++;
    const solver_status status = solver_solve(&sim->solver, &s->system.all, &sim->constraints,
                                              &limits, s->change, &sim->account.iterations);
    double longest = 0;
#pragma omp parallel for schedule(static) reduction(max : longest)
    for (int i = 0; i < vertices; i++)
        if (!b->driven[i]) {
            vector_scale(s->change[i], sim->step.h, b->displacement[i]);
            const double length = vector_length(b->displacement[i]);
            longest = length > longest ? length : longest;
        }
    *most = longest;
    /* An inexact direction is still a descent direction. */
    return status == SOLVER_NOT_FINITE || !isfinite(longest) ? SOLVER_NOT_FINITE : SOLVER_CONVERGED;
}

/* Returns the largest displacement, m, of all vertices or, with `driven_alone`, only of driven
 * ones. */
static double longest_displacement(const barrier *b, int driven_alone) {
    double most = 0;
#pragma omp parallel for schedule(static) reduction(max : most)
    for (int i = 0; i < b->surface.vertex_count; i++)
        if (b->driven[i] || !driven_alone) {
            const double length = vector_length(b->displacement[i]);
            most = length > most ? length : most;
        }
    return most;
}

/* Sets x = b->x + part * displacement; if `arrives`, driven vertices are set exactly to their
 * goals. */
static void displace(const barrier *b, double part, int arrives, double (*x)[3]) {
#pragma omp parallel for schedule(static)
    for (int i = 0; i < b->surface.vertex_count; i++)
        if (b->driven[i] && arrives)
            memcpy(x[i], b->goal[i], sizeof x[i]);
        else
            vector_add_scaled(b->x[i], part, b->displacement[i], x[i]);
}

/* The sum of a . b over free vertices. */
static double free_dot(const simulation *sim, const double (*a)[3], const double (*b)[3]) {
    const unsigned char *driven = sim->barrier->contact.driven;
    const int count = sim->mesh->vertex_count;
    double sum[CHUNK_SUM_MOST] = {0};
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        for (int i = chunk * chunk_sum_length(count); i < chunk_sum_end(count, chunk); i++)
            sum[chunk] += driven[i] ? 0 : vector_dot(a[i], b[i]);
    return chunk_sum_all(count, sum);
}

/* Replaces the search direction d by z + f d, with Newton's direction z, f = max(0, z . (r - r') /
 * (z' . r')) and r = -dE/d(dv); ' marks values of the previous iteration (Polak and Ribiere). The
 * projected Hessian omits negative terms and is too stiff: without conjugate directions three times
 * the number of systems is needed. */
static void make_conjugate(simulation *sim) {
    barrier_step *s = sim->barrier;
    barrier_descent *d = &s->descent;
    barrier *b = &s->contact;
    const double(*z)[3] = read_only(s->change), (*r)[3] = read_only(s->system.all.b);
    const double along = free_dot(sim, z, r);
    const double factor =
        d->along > 0 ? fmax(0, (along - free_dot(sim, z, read_only(d->residual))) / d->along) : 0;
    d->along = along;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < sim->mesh->vertex_count; i++) {
        vector_add_scaled(z[i], factor, d->direction[i], d->direction[i]);
        memcpy(d->residual[i], r[i], sizeof r[i]);
    }
    d->slope = -free_dot(sim, read_only(d->direction), r);
    if (!(d->slope < 0)) { /* not a descent direction */
        memcpy(d->direction, s->change, (size_t)sim->mesh->vertex_count * sizeof *d->direction);
        d->slope = -along;
    }
#pragma omp parallel for schedule(static)
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        if (!b->driven[i])
            vector_scale(d->direction[i], sim->step.h, b->displacement[i]);
}

/* Returns the position of the minimum of the parabola that has this slope at 0 and this change of
 * value at `part`, but at most `most`. Returns `most` if the parabola has no minimum. */
static double lowest_part(double slope, double change, double part, double most) {
    assert(part > 0 && part <= most);
    const double curvature = 2 * (change - slope * part) / (part * part);
    return curvature > 0 ? fmin(most, -slope / curvature) : most;
}

/* Line search: moves b->x by the fraction `newton` (at most `most`) of the displacement, halved
 * until E does not grow, or to the minimum of a parabola through the values if E is lower there.
 * Returns 0 if E grew after all halvings, otherwise 1. */
static int descend(simulation *sim, double newton, double most) {
    barrier *b = &sim->barrier->contact;
    const double before = potential(sim, read_only(b->x)), slope = sim->barrier->descent.slope;
    double(*trial)[3] = sim->barrier->trial, after = INFINITY, part = 2 * fmin(newton, most);
    for (int n = 0; n < most_halvings && !(after <= before + 1e-12 * fabs(before)); n++) {
        part /= 2;
        displace(b, part, 0, trial);
        after = potential(sim, read_only(trial));
    }
    if (!(after <= before + 1e-12 * fabs(before)))
        return 0;
    const double lowest = lowest_part(slope / newton, after - before, part, most);
    if (fabs(lowest - part) > 0.1 * part) {
        displace(b, lowest, 0, trial);
        if (!(potential(sim, read_only(trial)) < after))
            displace(b, part, 0, trial);
    }
    memcpy(b->x, trial, (size_t)b->surface.vertex_count * sizeof *trial);
    return 1;
}

/* Sets s->work to the work of bodies in the step plus the decrease of the barrier's energy. The
 * force on a body is the sum of the elements' gradients at its vertices. The work of pins follows
 * from the constraints' residual. Also counts the contacts and grips of the step. */
static void settle(simulation *sim) {
    barrier_step *s = sim->barrier;
    const barrier *b = &s->contact;
    s->work = s->begin_energy - barrier_energy(b, read_only(b->x));
    for (int i = sim->mesh->vertex_count; i < b->surface.vertex_count; i++) {
        double moved[3];
        vector_subtract(b->x[i], b->begin[i], moved);
        s->work += vector_dot(s->system.push[i], moved);
    }
    for (int k = 0; k < b->list.contacts; k++)
        sim->account
            .effects[b->list.contact[k].pair.collider < 0 ? EFFECT_SELF_COLLISION : EFFECT_CONTACT]
            .visited++;
    sim->account.effects[EFFECT_FRICTION].visited += b->list.grips;
    memcpy(sim->solver.residual, s->system.all.b,
           (size_t)sim->mesh->vertex_count * sizeof *sim->solver.residual);
}

/* Makes one iteration. Returns SOLVER_CONVERGED if the step is done, SOLVER_TOO_MANY_ITERATIONS if
 * more iterations are needed, or SOLVER_NOT_FINITE on failure. Each step makes at least one
 * iteration, so that the cloth falls even in the shortest step. */
static solver_status iterate(simulation *sim, int number) {
    barrier_step *s = sim->barrier;
    barrier *b = &s->contact;
    double most;
    if (barrier_find_contacts(b, read_only(b->x)) != 0 || assemble(sim) != 0)
        return SOLVER_NOT_FINITE;
    const double drive = longest_displacement(b, 1);
    if (find_displacements(sim, &most) == SOLVER_NOT_FINITE)
        return SOLVER_NOT_FINITE;
    if (drive > 0)
        s->descent.along = 0;
    else
        make_conjugate(sim);
    /* The line search covers a multiple of Newton's displacement, limited by the largest allowed.
     */
    const double reach =
        fmin(drive > 0 ? 1 : most_stretch, s->longest_displacement / longest_displacement(b, 0));
#pragma omp parallel for schedule(static)
    for (int i = 0; i < b->surface.vertex_count; i++)
        vector_scale(b->displacement[i], reach, b->displacement[i]);
    if (barrier_find_pairs(b, read_only(b->x), read_only(b->displacement)) != 0)
        return SOLVER_NOT_FINITE;
    const double part = barrier_allowed_part(b, read_only(b->x), read_only(b->displacement));
    assert(!(part > 1));
    s->blocked = (drive > 0 && number >= most_drives) || !(part > 0);
    if (s->blocked)
        return SOLVER_NOT_FINITE;
    if (drive > 0) {
        displace(b, part, part >= 1 && reach >= 1, b->x);
        return SOLVER_TOO_MANY_ITERATIONS;
    }
    /* If E grows after any displacement, it has reached its minimum up to rounding. */
    return !descend(sim, 1 / reach, part) || most <= s->still_distance ? SOLVER_CONVERGED
                                                                       : SOLVER_TOO_MANY_ITERATIONS;
}

void barrier_step_solve(simulation *sim) {
    barrier_step *s = sim->barrier;
    solver_status status = sim->step.out_of_memory ? SOLVER_NOT_FINITE : SOLVER_TOO_MANY_ITERATIONS;
    s->blocked = 0;
    s->descent.along = 0;
    for (int n = 0; n < most_iterations && status == SOLVER_TOO_MANY_ITERATIONS; n++)
        status = sim->stop && *sim->stop ? SOLVER_NOT_FINITE : iterate(sim, n);
    if (status != SOLVER_NOT_FINITE)
        settle(sim);
    sim->step.solver_status = status;
}

int barrier_step_move(simulation *sim) {
    const barrier_step *s = sim->barrier;
    int broken = sim->step.solver_status == SOLVER_NOT_FINITE;
    sim->step.push_work = s->work;
#pragma omp parallel for schedule(static) reduction(max : broken)
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++) {
            sim->step.x_next[i][a] = s->contact.x[i][a];
            sim->step.v_next[i][a] = (s->contact.x[i][a] - sim->state.x[i][a]) / sim->step.h;
            sim->step.dv[i][a] = sim->step.v_next[i][a] - sim->state.v[i][a];
            if (!isfinite(sim->step.v_next[i][a]))
                broken = 1;
        }
    return !broken;
}
