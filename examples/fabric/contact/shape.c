/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "shape.h"

#include <string.h>

#include "base/vector.h"
#include "mesh/surface.h"

static double sphere_distance(double radius, const double p[3], double normal[3]) {
    const double length = vector_unit(p, normal);
    if (!(length > 0))
        normal[2] = 1; /* at the centre any direction is correct */
    return length - radius;
}

/* Computes the normal of a point on a cylinder's axis: any direction perpendicular to the axis. */
static void set_across(const double axis[3], double normal[3]) {
    const double other[3] = {fabs(axis[0]) < 0.5 ? 1 : 0, fabs(axis[0]) < 0.5 ? 0 : 1, 0};
    vector_cross(axis, other, normal);
    vector_unit(normal, normal);
}

/* Returns the distance from the nearest point of a box or, for a point inside, minus the distance
 * from the nearest face. */
static double box_distance(const double half[3], const double p[3], double normal[3]) {
    double outside[3], depth = -INFINITY;
    int nearest = 0;
    for (int c = 0; c < 3; c++) {
        const double d = fabs(p[c]) - half[c];
        outside[c] = d > 0 ? d : 0;
        if (d > depth) {
            depth = d;
            nearest = c;
        }
    }
    const double length = vector_length(outside);
    for (int c = 0; c < 3; c++) {
        const double size = depth > 0 ? outside[c] / length : (c == nearest ? 1.0 : 0.0);
        normal[c] = copysign(size, p[c]);
    }
    return depth > 0 ? length : depth;
}

/* In the plane through the axis and the point, a cylinder with flat ends is a rectangle, that is, a
 * two-dimensional box. */
static double cylinder_distance(const collider *k, const double p[3], double normal[3]) {
    const double along = vector_dot(p, k->axis);
    double radial[3];
    vector_add_scaled(p, -along, k->axis, radial);
    const double radius = vector_length(radial);
    const double half[3] = {k->size[0], k->size[1], 1e300};
    const double flat[3] = {radius, along, 0};
    double direction[3];
    const double distance = box_distance(half, flat, direction);
    for (int c = 0; c < 3; c++) {
        const double out = radius > 0 ? radial[c] / radius : 0;
        normal[c] = direction[0] * out + direction[1] * k->axis[c];
    }
    if (radius <= 0 && fabs(direction[1]) < 0.5)
        set_across(k->axis, normal);
    return distance;
}

double shape_distance(const collider *k, const double p[3], double normal[3]) {
    switch (k->kind) {
    case COLLIDER_BOX:
        return box_distance(k->size, p, normal);
    case COLLIDER_SPHERE:
        return sphere_distance(k->size[0], p, normal);
    case COLLIDER_CYLINDER:
        return cylinder_distance(k, p, normal);
    case COLLIDER_MESH:
        return surface_distance(k->surface, p, normal);
    case COLLIDER_PLANE:
        break;
    }
    memcpy(normal, k->axis, sizeof k->axis);
    return vector_dot(p, k->axis);
}

int shape_approach(const collider *k, const double p[3], const double u[3], approach *found) {
    const double length = vector_length(u);
    const double near_enough = 1e-3 * k->gap + 1e-9;
    /* Only a path along a surface needs more steps; it is treated as a contact. */
    enum { most_steps = 64 };
    double at[3] = {p[0], p[1], p[2]};
    double path_done = 0;
    double left = shape_distance(k, p, found->normal) - k->gap;
    if (left > length + near_enough)
        return 0;
    if (left > near_enough) {
        for (int n = 0; left > near_enough && n < most_steps; n++) {
            path_done += left;
            if (path_done >= length)
                return 0;
            vector_add_scaled(p, path_done / length, u, at);
            left = shape_distance(k, at, found->normal) - k->gap;
        }
        /* `at` lies on the plane that the point must not cross. */
        vector_subtract(p, at, at);
        found->room = vector_dot(found->normal, at);
    } else {
        found->room = left;
    }
    found->beyond = -vector_dot(found->normal, u) - found->room;
    return found->beyond > -near_enough;
}
