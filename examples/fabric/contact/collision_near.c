/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds the colliders that the cloth may touch in a step. Colliders out of reach cost nothing. */
#include <assert.h>
#include <string.h>

#include "base/vector.h"
#include "collision.h"
#include "shape.h"

/* The bounding ball of the cloth, and the largest displacement of a vertex in the step, m. */
typedef struct cloth_ball {
    double center[3], radius, displacement;
} cloth_ball;

static cloth_ball ball_around(const collisions *c, double h, const double (*x)[3],
                              const double (*v)[3], const double (*dv)[3]) {
    cloth_ball ball = {{0, 0, 0}, 0, 0};
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double radius = 0, displacement = 0;
    for (int i = 0; i < c->mesh->vertex_count; i++)
        for (int a = 0; a < 3; a++) {
            low[a] = x[i][a] < low[a] ? x[i][a] : low[a];
            high[a] = x[i][a] > high[a] ? x[i][a] : high[a];
        }
    for (int a = 0; a < 3; a++) {
        ball.center[a] = (low[a] + high[a]) / 2;
        radius += (high[a] - low[a]) * (high[a] - low[a]) / 4;
    }
    for (int i = 0; v && i < c->mesh->vertex_count; i++) {
        double speed[3] = {v[i][0], v[i][1], v[i][2]};
        if (dv)
            vector_add_scaled(v[i], 1, dv[i], speed);
        const double square = vector_dot(speed, speed);
        displacement = !(square <= displacement) ? square : displacement;
    }
    ball.radius = sqrt(radius);
    ball.displacement = h * sqrt(displacement);
    return ball;
}

/* The distance from the cloth's centre to the collider, m. */
static double distance_to(const collider *k, const double center[3], double time) {
    double p[3], normal[3];
    motion_to_body(k, time, center, p);
    return shape_distance(k, p, normal);
}

/* Returns the distance from the cloth's centre at which a collider may touch the cloth, without the
 * collider's own motion and gap. */
static double reach_of(const cloth_ball *ball) {
    return 1.01 * (ball->radius + ball->displacement);
}

static double own_reach(const collider *k, double h) {
    return 1.01 * (h * vector_length(k->velocity) + 2 * k->gap + 1e-9);
}

/* Like own_reach, for a collider with keyframes. The bound covers the part of the collider that the
 * cloth may meet. */
static double own_reach_keyed(const collider *k, const body_motion *m, const cloth_ball *ball) {
    double from[3];
    vector_subtract(ball->center, m->begin.origin, from);
    const double reach = vector_length(from) + ball->radius + ball->displacement;
    return 1.01 * (motion_displacement(m, reach) + 2 * k->gap + 1e-9);
}

/* May a collider outside of `watched` touch the cloth by now? A distance changes by no more than
 * the displacements of the centre and of the collider. */
static int may_be_reached(const out_of_reach *others, const cloth_ball *ball, double time,
                          double h) {
    double moved[3];
    if (others->count < 0)
        return 1;
    vector_subtract(ball->center, others->center, moved);
    const double passed = fabs(time - others->time) + 1.01 * h;
    return !(others->clearance - vector_length(moved) - passed * others->speed > reach_of(ball));
}

/* Tests all colliders, and puts those into `watched` that the cloth might reach by moving a
 * distance equal to the cloth's size. Meshes and colliders with keyframes are always watched: the
 * distance to an open mesh may jump, and keyframes may begin at any time. */
static void test_all(collisions *c, const cloth_ball *ball, double time, double h) {
    out_of_reach *others = &c->others;
    const double margin = ball->radius + 4 * ball->displacement;
    *others = (out_of_reach){.watched = others->watched, .clearance = INFINITY, .time = time};
    memcpy(others->center, ball->center, sizeof others->center);
    for (int n = 0; n < c->scene->collider_count; n++) {
        const collider *k = &c->scene->colliders[n];
        if (!c->there[n])
            continue;
        const double clearance = distance_to(k, ball->center, time) - own_reach(k, 0);
        const double speed = vector_length(k->velocity);
        if (k->kind == COLLIDER_MESH || motion_has_keys(k) ||
            !(clearance - 1.01 * h * speed > reach_of(ball) + margin)) {
            others->watched[others->count++] = n;
            continue;
        }
        others->clearance = fmin(others->clearance, clearance);
        others->speed = fmax(others->speed, speed);
    }
    assert(others->count <= c->scene->collider_count);
}

void collisions_find_near(collisions *c, double time, double h, const double (*x)[3],
                          const double (*v)[3], const double (*dv)[3]) {
    c->any_near = 0;
    if (c->any_there == 0)
        return;
    const cloth_ball ball = ball_around(c, h, x, v, dv);
    if (may_be_reached(&c->others, &ball, time, h))
        test_all(c, &ball, time, h);
    for (int m = 0; m < c->others.count; m++) {
        const int n = c->others.watched[m];
        const collider *k = &c->scene->colliders[n];
        double own;
        if (motion_has_keys(k)) {
            motion_in_step(k, time, h, &c->motion[n]);
            own = own_reach_keyed(k, &c->motion[n], &ball);
        } else {
            own = own_reach(k, h);
        }
        if (!(distance_to(k, ball.center, time) > reach_of(&ball) + own))
            c->near_list[c->any_near++] = n;
    }
    assert(c->any_near <= c->others.count);
}
