/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Work and depth of contacts. */
#include "base/chunk_sum.h"
#include "base/vector.h"
#include "collision.h"
#include "shape.h"

/* Returns an upper bound on the work of friction, J. The friction's impulse -f (v - u) on a vertex
 * with velocity v, against a collider with velocity u, does the work -f (v - u) . v <= f u . u /
 * 4. */
static double friction_work(const contact *touch, double friction, const double carried[3],
                            double h) {
    if (touch->sticks || !(touch->force > 0))
        return 0;
    const double factor = h * friction * touch->force / touch->slip_speed;
    return factor * vector_dot(carried, carried) / 4;
}

/* Do only colliders at rest hold the vertex, without pushing it out? (Pushing out a vertex that is
 * too near does work.) */
static int is_held_at_rest(const collisions *c, int vertex) {
    if (collisions_pin_of(c, vertex) >= 0)
        return 0;
    for (int n = 0; n < c->now[vertex].count; n++) {
        if (c->now[vertex].list[n].speed > 0 || vector_length(collisions_carried(c, vertex, n)) > 0)
            return 0;
    }
    return 1;
}

/* A body at rest takes energy and gives none. If a constraint seems to give some, by pulling at an
 * approaching vertex, that is an error of the solution. Only the sum is meaningful: at single
 * vertices the solver's tolerance appears with either sign. */
double collisions_work(const collisions *c, const constraints *given, double h, double stage_h,
                       const double (*v)[3], const double (*residual)[3]) {
    const int count = c->mesh->vertex_count, contacts = c->now && !c->now_empty;
    double moving[CHUNK_SUM_MOST] = {0}, resting[CHUNK_SUM_MOST] = {0};
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        for (int i = chunk * chunk_sum_length(count); i < chunk_sum_end(count, chunk); i++) {
            if (given->given[i] > 0) { /* the constraint's impulse in the stage is -residual */
                double *sum = contacts && is_held_at_rest(c, i) ? resting : moving;
                sum[chunk] -= h / stage_h * vector_dot(residual[i], v[i]);
            }
            for (int n = 0; contacts && n < c->now[i].count; n++) {
                const contact *touch = &c->now[i].list[n];
                moving[chunk] += friction_work(touch, c->scene->colliders[touch->collider].friction,
                                               collisions_carried(c, i, n), h);
            }
        }
    const double from_resting = chunk_sum_all(count, resting);
    return chunk_sum_all(count, moving) + (from_resting < 0 ? from_resting : 0);
}

/* Returns the vertex's greatest depth in a near collider, m, or 0 if it is in none or pinned. */
static double depth_of(const collisions *c, int vertex, double time, const double x[3]) {
    double deepest = 0;
    for (int m = 0; m < c->any_near && collisions_pin_of(c, vertex) < 0; m++) {
        const collider *k = &c->scene->colliders[c->near_list[m]];
        double p[3], normal[3];
        motion_to_body(k, time, x, p);
        const double depth = -shape_distance(k, p, normal);
        if (depth > deepest)
            deepest = depth;
    }
    return deepest;
}

double collisions_depth(const collisions *c, double time, const double (*x)[3]) {
    double deepest = 0;
    if (!c->now || !c->any_near)
        return 0;
#pragma omp parallel for schedule(static) reduction(max : deepest)
    for (int i = 0; i < c->mesh->vertex_count; i++) {
        const double depth = depth_of(c, i, time, x[i]);
        if (depth > deepest)
            deepest = depth;
    }
    return deepest;
}

long collisions_inside(const collisions *c, double time, const double (*x)[3]) {
    long inside = 0;
    for (int i = 0; i < c->mesh->vertex_count && c->any_near > 0; i++)
        inside += depth_of(c, i, time, x[i]) > 0;
    return inside;
}
