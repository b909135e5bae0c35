/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Colliders that penetrate a triangle between its vertices: a thin rod, a tip, a small ball. */
#include <stdlib.h>
#include <string.h>

#include "base/arrays.h"
#include "base/vector.h"
#include "collision.h"
#include "shape_triangle.h"

/* Computes the triangle's corners in the collider's axes, and their displacements relative to
 * it. */
static void gather(const collisions *c, int number, const int corner[3], double time, double h,
                   const double (*x)[3], const double (*v)[3], double p[3][3], double u[3][3]) {
    const collider *k = &c->scene->colliders[number];
    const body_motion *motion = c->motion ? &c->motion[number] : NULL;
    for (int n = 0; n < 3; n++)
        motion_enter(k, motion, time, h, x[corner[n]], v[corner[n]], p[n], u[n]);
}

/* Calls shape_meets_triangle and converts its result from the collider's axes to space. */
static int meets(const collisions *c, int number, const double p[3][3], const double u[3][3],
                 double weight[3], approach *found) {
    const collider *k = &c->scene->colliders[number];
    double at[3] = {0, 0, 0};
    if (!shape_meets_triangle(k, p, u, weight, found))
        return 0;
    for (int n = 0; n < 3; n++)
        vector_add_scaled(at, weight[n], p[n], at);
    motion_carry(k, c->motion ? &c->motion[number] : NULL, at, found->normal, found->carried);
    return 1;
}

/* May the collider come near to some point of the triangle, even if impulses move that point by
 * another gap? */
static int may_meet(const collider *k, const double p[3][3], const double u[3][3]) {
    double middle[3], normal[3], radius = 0, displacement = 0;
    for (int a = 0; a < 3; a++)
        middle[a] = (p[0][a] + p[1][a] + p[2][a]) / 3;
    for (int n = 0; n < 3; n++) {
        double arm[3];
        vector_subtract(p[n], middle, arm);
        radius = fmax(radius, vector_length(arm));
        displacement = fmax(displacement, vector_length(u[n]));
    }
    return shape_distance(k, middle, normal) <= radius + displacement + 2 * k->gap;
}

/* Bounds the distance of far triangles from below by one distance per vertex. A point of a triangle
 * is nearer than its first corner by at most the longer edge at that corner. No vertex moves
 * farther than the longest displacement. */
typedef struct clearances {
    const double *distance; /* [vertices] m, distance to the collider as the step begins; NULL:
                             * unknown */
    double displacement;    /* m, longest displacement of a vertex relative to the collider */
} clearances;

/* Leaves `distance` NULL for a mesh: the distance to an open mesh may jump, so it bounds
 * nothing. */
static int find_clearances(collisions *c, int number, double time, double h, const double (*x)[3],
                           const double (*v)[3], clearances *found) {
    const collider *k = &c->scene->colliders[number];
    const body_motion *motion = c->motion ? &c->motion[number] : NULL;
    double displacement = 0;
    *found = (clearances){NULL, 0};
    if (k->kind == COLLIDER_MESH)
        return 0;
    if (!c->met.distance)
        c->met.distance = malloc(((size_t)c->mesh->vertex_count + 1) * sizeof *c->met.distance);
    if (!c->met.distance)
        return -1;
#pragma omp parallel for schedule(static) reduction(max : displacement)
    for (int i = 0; i < c->mesh->vertex_count; i++) {
        double p[3], u[3], normal[3];
        motion_enter(k, motion, time, h, x[i], v[i], p, u);
        c->met.distance[i] = shape_distance(k, p, normal);
        const double square = vector_dot(u, u);
        displacement = square > displacement ? square : displacement;
    }
    *found = (clearances){c->met.distance, sqrt(displacement)};
    return 0;
}

/* True only if may_meet is false. Let L be the longer edge at the first corner: the middle is at
 * most 2/3 L from that corner, and every corner at most L from the middle. So may_meet requires
 * reach <= 5/3 L, and this tests reach > 2 L. */
static int is_far(const clearances *known, const collider *k, const int corner[3],
                  const double (*x)[3]) {
    if (!known->distance)
        return 0;
    const double reach = known->distance[corner[0]] - known->displacement - 2 * k->gap;
    double one[3], other[3];
    vector_subtract(x[corner[1]], x[corner[0]], one);
    vector_subtract(x[corner[2]], x[corner[0]], other);
    return reach > 0 && 4 * fmax(vector_dot(one, one), vector_dot(other, other)) < reach * reach;
}

static int add(met_triangles *met, int triangle, int collider_number, double gap) {
    if (array_grow(&met->list, &met->room, (long)met->count + 1, sizeof *met->list) != 0)
        return -1;
    met->gap = fmin(met->gap, gap);
    met->list[met->count++] = (met_triangle){.triangle = triangle, .collider = collider_number};
    return 0;
}

int collisions_find_triangles(collisions *c, double time, double h, const double (*x)[3],
                              const double (*v)[3]) {
    c->met.count = c->met.left = 0;
    c->met.gap = INFINITY;
    for (int m = 0; m < c->any_near; m++) {
        const int n = c->near_list[m];
        const collider *k = &c->scene->colliders[n];
        if (k->kind == COLLIDER_PLANE)
            continue;
        clearances known;
        if (!c->met.is_near)
            c->met.is_near = malloc((size_t)c->mesh->triangle_count + 1);
        if (!c->met.is_near || find_clearances(c, n, time, h, x, v, &known) != 0)
            return -1;
#pragma omp parallel for schedule(static)
        for (int t = 0; t < c->mesh->triangle_count; t++) {
            double p[3][3], u[3][3];
            c->met.is_near[t] = 0;
            if (is_far(&known, k, c->mesh->triangle[t], x))
                continue;
            gather(c, n, c->mesh->triangle[t], time, h, x, v, p, u);
            c->met.is_near[t] =
                (unsigned char)may_meet(k, (const double(*)[3])p, (const double(*)[3])u);
        }
        for (int t = 0; t < c->mesh->triangle_count; t++)
            if (c->met.is_near[t] && add(&c->met, t, n, k->gap) != 0)
                return -1;
    }
    return 0;
}

/* Computes where the collider penetrates the triangle, unless that is known: the result depends
 * only on the corners' velocities. */
static void update(const collisions *c, met_triangle *met, double time, double h,
                   const double (*x)[3], const double (*v)[3]) {
    const int *corner = c->mesh->triangle[met->triangle];
    double now[3][3], p[3][3], u[3][3];
    for (int n = 0; n < 3; n++)
        memcpy(now[n], v[corner[n]], sizeof now[n]);
    if (met->is_known && memcmp(now, met->v, sizeof now) == 0)
        return;
    gather(c, met->collider, corner, time, h, x, v, p, u);
    met->meets = meets(c, met->collider, (const double(*)[3])p, (const double(*)[3])u, met->weight,
                       &met->found);
    memcpy(met->v, now, sizeof now);
    met->is_known = 1;
}

/* Runs in parallel at the beginning of a round. Afterwards only triangles that impulses of this
 * round move are computed again. */
static void update_all(collisions *c, double time, double h, const double (*x)[3],
                       const double (*v)[3]) {
    if (c->met.count == 0)
        return;
#pragma omp parallel for schedule(dynamic, 4)
    for (int n = 0; n < c->met.count; n++)
        update(c, &c->met.list[n], time, h, x, v);
}

static feature point_of(const collisions *c, const met_triangle *met) {
    const int *corner = c->mesh->triangle[met->triangle];
    return (feature){.count = 3,
                     .vertex = {corner[0], corner[1], corner[2]},
                     .weight = {met->weight[0], met->weight[1], met->weight[2]}};
}

double collisions_push_triangles(collisions *c, const movable *of, double time, double h,
                                 const double (*x)[3], double (*v)[3], double *work) {
    double largest = 0;
    update_all(c, time, h, x, (const double(*)[3])v);
    for (int n = 0; n < c->met.count; n++) {
        met_triangle *met = &c->met.list[n];
        double speed[3];
        update(c, met, time, h, x, (const double(*)[3])v);
        if (!met->meets)
            continue;
        const collider *k = &c->scene->colliders[met->collider];
        const feature point = point_of(c, met);
        const approach *found = &met->found;
        feature_velocity(&point, (const double(*)[3])v, speed);
        const double change =
            collisions_given_speed(c, k, found, h) - vector_dot(found->normal, speed);
        if (change > 0 &&
            impulse_give(of, &point, found->normal, change, k->friction, found->carried, v, work))
            largest = fmax(largest, change);
    }
    return largest;
}

void collisions_check_triangles(collisions *c, const movable *of, double time, double h,
                                const double (*x)[3], const double (*v)[3]) {
    int left = 0;
    update_all(c, time, h, x, v);
#pragma omp parallel for schedule(static) reduction(+ : left)
    for (int n = 0; n < c->met.count; n++) {
        const met_triangle *met = &c->met.list[n];
        const collider *k = &c->scene->colliders[met->collider];
        const feature point = point_of(c, met);
        /* A collider halfway between the allowed depth and its middle has not passed yet. */
        left += met->meets &&
                met->found.beyond > (1 - TRIANGLE_DEPTH_PART) / 2 * shape_inner_radius(k) &&
                impulse_is_possible(of, &point, v, met->found.normal);
    }
    c->met.left = left;
}
