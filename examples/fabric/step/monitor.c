/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "monitor.h"

#include <assert.h>
#include <string.h>

#include "base/chunk_sum.h"
#include "base/vector.h"
#include "effects/outer_force.h"

const char *monitor_verdict_name(monitor_verdict verdict) {
    assert(verdict < STEP_VERDICT_COUNT);
    static const char *const names[STEP_VERDICT_COUNT] = {
        [STEP_GOOD] = "good",       [STEP_NOT_FINITE] = "not finite",
        [STEP_STRAIN] = "strain",   [STEP_NOT_SOLVED] = "not solved",
        [STEP_ENERGY] = "energy",   [STEP_PENETRATION] = "penetration",
        [STEP_PASSING] = "passing", [STEP_NO_ROOM] = "no room"};
    return names[verdict];
}

static double kinetic_energy(int count, const double *mass, const double (*v)[3]) {
    double sum[CHUNK_SUM_MOST] = {0};
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        for (int i = chunk * chunk_sum_length(count); i < chunk_sum_end(count, chunk); i++)
            sum[chunk] += mass[i] * vector_dot(v[i], v[i]) / 2;
    return chunk_sum_all(count, sum);
}

/* The work of gravity, sum m g . dx, J. */
static double gravity_work(int count, const double *mass, const double gravity[3],
                           const double (*x)[3], const double (*x_next)[3]) {
    double sum[CHUNK_SUM_MOST] = {0};
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        for (int i = chunk * chunk_sum_length(count); i < chunk_sum_end(count, chunk); i++) {
            double moved[3];
            vector_subtract(x_next[i], x[i], moved);
            sum[chunk] += mass[i] * vector_dot(gravity, moved);
        }
    return chunk_sum_all(count, sum);
}

static double elastic_energy(const monitored_step *step, const double (*x)[3]) {
    const triangle_material *t = &step->cloth->triangle_material;
    double stretch = 0, shear = 0, bend = 0;
    if (t->stretch > 0 || t->shear > 0)
        triangle_energies(&step->cloth->triangles, t, x, &stretch, &shear);
    if (step->cloth->hinge_material.bend > 0)
        bend = hinge_energy_at(&step->cloth->hinges, &step->cloth->hinge_material, x);
    if (step->limit)
        stretch += strain_limit_energy(step->limit, &step->cloth->triangles, x);
    return stretch + shear + bend;
}

/* Work of external forces: gravity, outer forces, constraints, friction. */
static double outside_work(const monitored_step *step, const scene *s) {
    const int count = step->collisions->mesh->vertex_count;
    double work = 0;
    if (vector_length(s->surroundings.gravity) > 0)
        work +=
            gravity_work(count, step->cloth->mass, s->surroundings.gravity, step->x, step->x_next);
    const force_target on = {&s->surroundings, &step->cloth->triangles, step->wind};
#define OUTER_FORCE(NAME, name)                                                                    \
    work += outer_force_##name.work(&on, step->h, step->x, step->v_next);
#include "effects/effects.def"
    return work + step->push_work +
           collisions_work(step->collisions, step->given, step->h, step->stage_h, step->v_next,
                           step->residual);
}

/* Returns the energy of strains and angles of 1e-12, which some thousand rounding errors cause. */
static double energy_of_rounding(const struct cloth *cloth) {
    const triangle_material *t = &cloth->triangle_material;
    double area = 0, weight = 0;
    for (int k = 0; k < cloth->triangles.count; k++)
        area += cloth->triangles.rest[k].area;
    for (int k = 0; k < cloth->hinges.count; k++)
        weight += cloth->hinges.weight[k];
    return 1e-24 * ((t->stretch + t->shear) * area + cloth->hinge_material.bend * weight);
}

void monitor_begin(monitor *m, const scene *s, const monitored_step *start) {
    *m = (monitor){.scene = s};
    if (!start->watched)
        return;
    m->strain = triangle_greatest_strain(&start->cloth->triangles, start->x);
    m->energy =
        kinetic_energy(start->collisions->mesh->vertex_count, start->cloth->mass, start->v) +
        elastic_energy(start, start->x);
    m->depth = collisions_depth(start->collisions, start->time, start->x);
    m->reference = m->energy;
    m->greatest_strain = m->strain;
    m->deepest = m->start_depth = m->depth;
    m->start_inside = collisions_inside(start->collisions, start->time, start->x);
    m->noise = energy_of_rounding(start->cloth);
}

static monitor_verdict complain(monitor *m, monitor_verdict verdict, double value, double limit) {
    m->value = value;
    m->limit = limit;
    return verdict;
}

/* Is the fault accepted, because halving is impossible or would not help? Stores the answer. */
static int tolerates(monitor *m, const monitored_step *step, monitor_verdict verdict) {
    assert(verdict > STEP_GOOD && verdict < STEP_VERDICT_COUNT);
    const int is_contact = verdict == STEP_PASSING || verdict == STEP_PENETRATION;
    m->tolerated[verdict] = step->shortest || (is_contact && step->futile);
    return m->tolerated[verdict];
}

/* Does the step keep the energy? Neither one step nor all steps together may gain more than this
 * fraction of the initial and the added energy: small gains add up, especially in short steps. */
static int keeps_energy(monitor *m, double part) {
    const double given = m->reference + fabs(m->work), most = part * given + m->noise;
    const double in_step = m->next_energy - m->energy - m->work, in_all = m->next_energy - given;
    if (in_step <= most && in_all <= most)
        return 1;
    complain(m, STEP_ENERGY, in_step <= most ? in_all : in_step, most);
    return 0;
}

/* Checks the step against the scene's limits. */
static monitor_verdict check_limits(monitor *m, const monitored_step *step) {
    const monitor_limits *limits = &m->scene->monitor;
    if (m->next_strain - m->strain >= limits->growth && m->next_strain >= limits->strain &&
        !tolerates(m, step, STEP_STRAIN))
        return complain(m, STEP_STRAIN, m->next_strain - m->strain, limits->growth);
    m->next_energy =
        kinetic_energy(step->collisions->mesh->vertex_count, step->cloth->mass, step->v_next) +
        elastic_energy(step, step->x_next);
    m->work = outside_work(step, m->scene);
    if (!keeps_energy(m, limits->energy))
        return STEP_ENERGY;
    m->next_depth = collisions_depth(step->collisions, step->time + step->h, step->x_next);
    if (m->next_depth > limits->penetration && m->next_depth > m->depth &&
        !tolerates(m, step, STEP_PENETRATION))
        return complain(m, STEP_PENETRATION, m->next_depth, limits->penetration);
    return STEP_GOOD;
}

monitor_verdict monitor_check(monitor *m, const monitored_step *step) {
    memset(m->tolerated, 0, sizeof m->tolerated);
    m->next_strain =
        step->watched ? triangle_greatest_strain(&step->cloth->triangles, step->x_next) : 0;
    if (!step->finite || !isfinite(m->next_strain))
        return complain(m, STEP_NOT_FINITE, NAN, 0);
    if (step->status != SOLVER_CONVERGED && !tolerates(m, step, STEP_NOT_SOLVED))
        return complain(m, STEP_NOT_SOLVED, step->status, SOLVER_CONVERGED);
    if (step->watched) {
        const monitor_verdict verdict = check_limits(m, step);
        if (verdict != STEP_GOOD)
            return verdict;
    }
    if (step->passing > 0 && !tolerates(m, step, STEP_PASSING))
        return complain(m, STEP_PASSING, step->passing, 0);
    return STEP_GOOD;
}

int monitor_futile_parts(const monitor *m) {
    assert(m->passing_in_a_row >= 0);
    enum { steps_let_pass = 32, most_doublings = 20 };
    const long doublings = m->passing_in_a_row / steps_let_pass;
    return 1 << (doublings < most_doublings ? doublings : most_doublings);
}

void monitor_accept(monitor *m) {
    const int passed = m->tolerated[STEP_PASSING] || m->tolerated[STEP_PENETRATION];
    m->passing_in_a_row = passed ? m->passing_in_a_row + 1 : 0;
    for (int k = 0; k < STEP_VERDICT_COUNT; k++)
        m->let_pass[k] += m->tolerated[k];
    m->strain = m->next_strain;
    m->energy = m->next_energy;
    m->depth = m->next_depth;
    m->reference += fabs(m->work);
    m->greatest_strain = fmax(m->greatest_strain, m->strain);
    m->deepest = fmax(m->deepest, m->depth);
}
