/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "impulse.h"

#include <assert.h>

#include "base/vector.h"
#include "collision.h"

int movable_is_held(const movable *of, int vertex) {
    const collisions *c = of->bodies;
    return collisions_pin_of(c, vertex) >= 0 || (c->now && c->now[vertex].count > 0);
}

/* Returns the speed, m/s, at which the vertex moves away from its contact's body, less the speed
 * that the contact prescribes. A difference within the rounding of v, or below 0, counts as 0. */
static double leaving_speed(const contact *touch, const double v[3]) {
    static const double rounding = 1e-9;
    const double speed = vector_dot(touch->normal, v) - touch->speed;
    return speed > rounding * (vector_length(v) + fabs(touch->speed)) ? speed : 0;
}

void movable_part(const movable *of, int i, const double v[3], const double d[3], double part[3]) {
    const collisions *c = of->bodies;
    const int pinned = collisions_pin_of(c, i) >= 0;
    for (int a = 0; a < 3; a++)
        part[a] = pinned ? 0 : d[a];
    if (pinned || !c->now)
        return;
    for (int n = 0; n < c->now[i].count; n++) {
        const contact *touch = &c->now[i].list[n];
        const double along = vector_dot(part, touch->normal);
        if (along < 0 && !(leaving_speed(touch, v) > 0))
            vector_add_scaled(part, -along, touch->normal, part);
    }
}

void movable_move(const movable *of, int i, const double change[3], double v[3]) {
    const collisions *c = of->bodies;
    double left[CONTACTS_PER_VERTEX];
    const int count = c->now ? c->now[i].count : 0;
    assert(count <= CONTACTS_PER_VERTEX);
    for (int n = 0; n < count; n++)
        left[n] = leaving_speed(&c->now[i].list[n], v);
    vector_add_scaled(v, 1, change, v);
    for (int n = 0; n < count; n++) {
        const contact *touch = &c->now[i].list[n];
        const double beyond = touch->speed - vector_dot(touch->normal, v);
        if (left[n] > 0 && beyond > 0)
            vector_add_scaled(v, beyond, touch->normal, v);
    }
}

/* Computes the change of velocity that the impulse d (kg m/s) gives vertex i, m/s. It is 0 if a
 * body takes most of the impulse: the remainder points sideways and would have to be many times as
 * large. */
static void response(const movable *of, int i, const double v[3], const double d[3],
                     double change[3]) {
    static const double least_part = 0.25; /* least part of d'd that may be free */
    double light = of->mass[i] > 0 ? 1 / of->mass[i] : 0;
    movable_part(of, i, v, d, change);
    if (!(vector_dot(change, d) >= least_part * vector_dot(d, d)))
        light = 0;
    vector_scale(change, light, change);
}

/* Returns the change of the feature's velocity along the unit vector d, for an impulse of 1 kg
 * m/s. */
static double mobility(const movable *of, const feature *f, const double (*v)[3],
                       const double d[3]) {
    assert(f->count >= 1 && f->count <= 4);
    double sum = 0;
    for (int k = 0; k < f->count; k++) {
        double pushed[3], change[3];
        vector_scale(d, f->weight[k], pushed);
        response(of, f->vertex[k], v[f->vertex[k]], pushed, change);
        sum += vector_dot(pushed, change);
    }
    return sum;
}

void feature_velocity(const feature *f, const double (*v)[3], double speed[3]) {
    assert(f->count >= 1 && f->count <= 4);
    speed[0] = speed[1] = speed[2] = 0;
    for (int k = 0; k < f->count; k++)
        vector_add_scaled(speed, f->weight[k], v[f->vertex[k]], speed);
}

/* Applies the impulse to the feature's vertices. Returns the energy that it gives, J. */
static double apply(const movable *of, const feature *f, const double impulse[3], double (*v)[3]) {
    double work = 0;
    for (int k = 0; k < f->count; k++) {
        const int i = f->vertex[k];
        double pushed[3], moved[3];
        vector_scale(impulse, f->weight[k], pushed);
        response(of, i, v[i], pushed, moved);
        const double before = vector_dot(v[i], v[i]);
        movable_move(of, i, moved, v[i]);
        work += of->mass[i] * (vector_dot(v[i], v[i]) - before) / 2;
    }
    return work;
}

/* Computes the friction impulse: at most `most` kg m/s, and no more than stops the sliding. */
static void find_friction(const movable *of, const feature *f, const double normal[3], double most,
                          const double *base, const double (*v)[3], double impulse[3]) {
    double slip[3];
    feature_velocity(f, v, slip);
    if (base)
        vector_subtract(slip, base, slip);
    vector_add_scaled(slip, -vector_dot(slip, normal), normal, slip);
    const double speed = vector_unit(slip, slip);
    const double light = mobility(of, f, v, slip);
    const double stops = light > 0 ? speed / light : 0;
    vector_scale(slip, -(stops < most ? stops : most), impulse);
}

int impulse_is_possible(const movable *of, const feature *f, const double (*v)[3],
                        const double normal[3]) {
    static const double least_part = 0.02; /* least mobility, relative to that if all vertices were
                                            * free */
    double all_free = 0;
    for (int k = 0; k < f->count; k++) {
        const double mass = of->mass[f->vertex[k]];
        all_free += mass > 0 ? f->weight[k] * f->weight[k] / mass : 0;
    }
    const double light = mobility(of, f, v, normal);
    return light > 0 && light >= least_part * all_free;
}

int impulse_give(const movable *of, const feature *f, const double normal[3], double change,
                 double friction, const double *base, double (*v)[3], double *work) {
    const double light = mobility(of, f, (const double(*)[3])v, normal);
    double impulse[3] = {0, 0, 0};
    if (!impulse_is_possible(of, f, (const double(*)[3])v, normal))
        return 0;
    assert(light > 0 && change > 0 && friction >= 0);
    vector_add_scaled(impulse, change / light, normal, impulse);
    *work += apply(of, f, impulse, v);
    if (friction > 0) {
        find_friction(of, f, normal, friction * change / light, base, (const double(*)[3])v,
                      impulse);
        *work += apply(of, f, impulse, v);
    }
    return 1;
}
