/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * The state of a simulation between two steps of the scene: positions, velocities, and all else
 * that later steps depend on. Data that scene and mesh determine, and data that each step computes
 * (the system, the constraints, contacts found, limited triangles), is left out.
 */
#include <stdint.h>
#include <string.h>

#include "simulation_state.h"

/**
 * Serialisation in both directions: one function for each part of the state passes its values in
 * order to archive_pass, which counts, stores or loads them. Bytes are in the machine's formats.
 */
typedef enum archive_mode { ARCHIVE_COUNT, ARCHIVE_STORE, ARCHIVE_LOAD } archive_mode;

typedef struct archive {
    archive_mode mode;
    unsigned char *bytes; /* [size] bytes to write or read, not owned; NULL while counting */
    size_t size;
    size_t used;
    int failed; /* true: more was requested than is left, or a value is invalid */
} archive;

/** Copies `size` bytes from or to `value`. If `bytes` has too few left, sets `failed`; from then on
 *  copies nothing. */
static void archive_pass(archive *a, void *value, size_t size) {
    if (a->mode != ARCHIVE_COUNT && (a->failed || size > a->size - a->used)) {
        a->failed = 1;
        return;
    }
    if (a->mode == ARCHIVE_STORE && size > 0)
        memcpy(a->bytes + a->used, value, size);
    else if (a->mode == ARCHIVE_LOAD && size > 0)
        memcpy(value, a->bytes + a->used, size);
    a->used += size;
}

static void archive_int(archive *a, int *value) {
    archive_pass(a, value, sizeof *value);
}

/** Passes a long as 64 bits. */
static void archive_long(archive *a, long *value) {
    int64_t wide = *value;
    archive_pass(a, &wide, sizeof wide);
    *value = (long)wide;
}

static void archive_double(archive *a, double *value) {
    archive_pass(a, value, sizeof *value);
}

static void archive_doubles(archive *a, double *values, size_t count) {
    archive_pass(a, values, sizeof *values * count);
}

/** Passes an int. Fails if the loaded value is not from `low` to `high`. */
static void archive_int_within(archive *a, int *value, int low, int high) {
    archive_int(a, value);
    if (a->mode == ARCHIVE_LOAD && (*value < low || *value > high)) {
        *value = low;
        a->failed = 1;
    }
}

static size_t coordinates(const simulation *sim) {
    return 3 * (size_t)sim->mesh->vertex_count;
}

static void pass_motion(archive *a, simulation *sim) {
    archive_doubles(a, &sim->state.x[0][0], coordinates(sim));
    archive_doubles(a, &sim->state.v[0][0], coordinates(sim));
    archive_doubles(a, &sim->step.guess[0][0], coordinates(sim));
    archive_double(a, &sim->step.guess_h);
}

/* Angles are stored because they count whole rotations. The cache of hinge_energy_at is not
 * stored. */
static void pass_angles(archive *a, simulation *sim) {
    archive_doubles(a, sim->cloth.hinges.angle, (size_t)sim->cloth.hinges.count);
    if (a->mode == ARCHIVE_LOAD)
        sim->cloth.hinges.has_cached = 0;
}

static void pass_integrator(archive *a, integrator_memory *of, size_t count) {
    if (of->kind == INTEGRATOR_BDF2) {
        archive_doubles(a, &of->x_before[0][0], count);
        archive_doubles(a, &of->v_before[0][0], count);
        archive_double(a, &of->h_before);
    }
    archive_long(a, &of->iterations);
}

static void pass_contact(archive *a, contact *touch, int colliders) {
    archive_int_within(a, &touch->collider, 0, colliders - 1);
    archive_int(a, &touch->sticks);
    archive_int(a, &touch->pulls);
    archive_doubles(a, touch->normal, 3);
    archive_double(a, &touch->speed);
    archive_double(a, &touch->force);
    archive_double(a, &touch->slip_speed);
}

/* Passes the contacts of the last accepted step: whether they stick, their forces, how long they
 * pull. */
static void pass_contacts(archive *a, collisions *c) {
    archive_long(a, &c->visits);
    archive_long(a, &c->friction_visits);
    if (!c->before)
        return;
    archive_int_within(a, &c->before_empty, 0, 1);
    for (int i = 0; i < c->mesh->vertex_count && !c->before_empty; i++) {
        vertex_contacts *of = &c->before[i];
        archive_int_within(a, &of->count, 0, CONTACTS_PER_VERTEX);
        for (int n = 0; n < of->count; n++)
            pass_contact(a, &of->list[n], c->scene->collider_count);
    }
}

static void pass_monitor(archive *a, monitor *m) {
    archive_double(a, &m->strain);
    archive_double(a, &m->energy);
    archive_double(a, &m->depth);
    archive_double(a, &m->reference);
    for (int k = 0; k < STEP_VERDICT_COUNT; k++)
        archive_long(a, &m->let_pass[k]);
    archive_long(a, &m->passing_in_a_row);
    archive_double(a, &m->greatest_strain);
    archive_double(a, &m->deepest);
}

/* Passes the current time and the length of the next step. */
static void pass_time(archive *a, simulation *sim) {
    archive_long(a, &sim->state.frame);
    archive_int_within(a, &sim->step.ticks, 1, TICKS_PER_STEP);
    archive_int(a, &sim->step.easy_steps);
    archive_int(a, &sim->step.slow_steps);
    archive_double(a, &sim->in_force.plan_time);
    if (a->mode != ARCHIVE_LOAD)
        return;
    sim->state.ticks_done = 0;
    sim->state.part = 0;
    a->failed |= sim->state.frame < 0 || TICKS_PER_STEP % sim->step.ticks != 0;
    plan_return_to(sim, sim->in_force.plan_time);
}

/* Passes a rejection. Its reason is one of the monitor's constant strings, so the string's number
 * is stored. */
static void pass_rejection(archive *a, rejection *r) {
    int verdict = 0;
    while (a->mode == ARCHIVE_STORE && verdict + 1 < STEP_VERDICT_COUNT &&
           strcmp(monitor_verdict_name((monitor_verdict)verdict), r->reason) != 0)
        verdict++;
    archive_int_within(a, &verdict, 0, STEP_VERDICT_COUNT - 1);
    if (a->mode == ARCHIVE_LOAD)
        r->reason = monitor_verdict_name((monitor_verdict)verdict);
    archive_double(a, &r->time);
    archive_double(a, &r->h);
    archive_double(a, &r->value);
    archive_double(a, &r->limit);
}

static void pass_counts(archive *a, simulation *sim) {
    archive_long(a, &sim->account.iterations);
    archive_long(a, &sim->fallback.solved);
    archive_int(a, &sim->fallback.next);
    archive_int_within(a, &sim->fallback.failed, 0, 1);
    archive_int_within(a, &sim->fallback.costly, 0, 1);
    archive_long(a, &sim->account.steps_taken);
    archive_long(a, &sim->account.steps_rejected);
    archive_long(a, &sim->account.steps_slept);
    archive_long(a, &sim->account.plans_changed);
    archive_long(a, &sim->self_collision.visits);
    a->failed |= sim->account.steps_rejected < 0 ||
                 (sim->account.steps_rejected > 0 && simulation_log_rejections(sim) != 0);
    for (long n = 0; n < sim->account.steps_rejected && n < MOST_REJECTIONS && !a->failed; n++)
        pass_rejection(a, &sim->account.rejections[n]);
    for (int k = 0; k < PHASE_COUNT; k++)
        archive_long(a, &sim->account.phases[k].calls);
    for (int k = 0; k < EFFECT_COUNT; k++)
        archive_long(a, &sim->account.effects[k].visited);
}

/* Times come last, so that archives of two equal runs differ only at the end. */
static void pass_seconds(archive *a, simulation *sim) {
    for (int k = 0; k < PHASE_COUNT; k++)
        archive_double(a, &sim->account.phases[k].seconds);
    for (int k = 0; k < EFFECT_COUNT; k++)
        archive_double(a, &sim->account.effects[k].seconds);
}

static void pass_all(archive *a, simulation *sim) {
    pass_time(a, sim);
    pass_motion(a, sim);
    pass_angles(a, sim);
    pass_integrator(a, &sim->integrator, coordinates(sim));
    pass_contacts(a, &sim->collisions);
    pass_monitor(a, &sim->monitor);
    pass_counts(a, sim);
    pass_seconds(a, sim);
}

size_t simulation_saved_size(simulation *sim) {
    archive a = {.mode = ARCHIVE_COUNT};
    pass_all(&a, sim);
    return a.used;
}

void simulation_save(simulation *sim, unsigned char *bytes, size_t size) {
    archive a = {.mode = ARCHIVE_STORE, .bytes = bytes, .size = size};
    pass_all(&a, sim);
}

int simulation_restore(simulation *sim, unsigned char *bytes, size_t size) {
    archive a = {.mode = ARCHIVE_LOAD, .bytes = bytes, .size = size};
    pass_all(&a, sim);
    return a.failed || a.used != size ? -1 : 0;
}
