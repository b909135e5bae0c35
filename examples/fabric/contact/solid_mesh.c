/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Colliders as triangles: for files, and for barriers (barrier.h). */
#include "contact/shape.h"

#include <assert.h>
#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "mesh/mesh_parts.h"
#include "mesh/surface.h"

enum { AROUND = 48, DOWN = 24 };
static const double PI = 3.14159265358979323846;

static void set_triangle(mesh *m, int number, int a, int b, int c) {
    assert(number >= 0 && number < m->triangle_count);
    assert(a < m->vertex_count && b < m->vertex_count && c < m->vertex_count);
    m->triangle[number][0] = a;
    m->triangle[number][1] = b;
    m->triangle[number][2] = c;
}

/** Vertex k is at + or - half an edge along x, y, z, as bits 0, 1, 2 of k say. */
static int box_mesh(const collider *c, mesh *m) {
    static const int corner[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                      {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                      {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    if (mesh_allocate(m, 8, 12) != 0)
        return -1;
    for (int k = 0; k < 8; k++)
        for (int a = 0; a < 3; a++)
            m->position[k][a] = (k >> a & 1) != 0 ? c->size[a] : -c->size[a];
    static_assert(sizeof corner == 12 * sizeof *m->triangle, "a row for each triangle");
    memcpy(m->triangle, corner, sizeof corner);
    return 0;
}

/** Makes rings of AROUND vertices between two end vertices: number 0 before ring 0, and the last
 *  number after the last ring. */
static int rings_mesh(mesh *m, int rings) {
    int t = 0;
    if (mesh_allocate(m, rings * AROUND + 2, 2 * AROUND * rings) != 0)
        return -1;
    for (int k = 0; k < AROUND; k++) {
        const int next = (k + 1) % AROUND, last = (rings - 1) * AROUND + 1;
        set_triangle(m, t++, 0, 1 + k, 1 + next);
        set_triangle(m, t++, m->vertex_count - 1, last + next, last + k);
        for (int ring = 0; ring < rings - 1; ring++) {
            const int above = 1 + ring * AROUND, below = above + AROUND;
            set_triangle(m, t++, above + k, below + k, below + next);
            set_triangle(m, t++, above + k, below + next, above + next);
        }
    }
    assert(t == m->triangle_count);
    return 0;
}

static int sphere_mesh(const collider *c, mesh *m) {
    const double radius = c->size[0];
    if (rings_mesh(m, DOWN - 1) != 0)
        return -1;
    m->position[0][2] = radius;
    m->position[m->vertex_count - 1][2] = -radius;
    for (int ring = 0; ring < DOWN - 1; ring++)
        for (int k = 0; k < AROUND; k++) {
            const double latitude = PI * (0.5 - (ring + 1) / (double)DOWN);
            const double longitude = 2 * PI * k / (double)AROUND;
            double *at = m->position[1 + ring * AROUND + k];
            at[0] = radius * cos(latitude) * cos(longitude);
            at[1] = radius * cos(latitude) * sin(longitude);
            at[2] = radius * sin(latitude);
        }
    return 0;
}

/** Computes two unit vectors at right angles to the axis and to each other, with first x second =
 *  axis (cross product). */
static void axes_across(const double axis[3], double first[3], double second[3]) {
    const double other[3] = {fabs(axis[0]) < 0.9 ? 1 : 0, fabs(axis[0]) < 0.9 ? 0 : 1, 0};
    vector_cross(other, axis, second);
    vector_unit(second, second);
    vector_cross(second, axis, first);
}

static int cylinder_mesh(const collider *c, mesh *m) {
    const double radius = c->size[0], half = c->size[1];
    double first[3], second[3];
    axes_across(c->axis, first, second);
    if (rings_mesh(m, 2) != 0)
        return -1;
    for (int a = 0; a < 3; a++) {
        m->position[0][a] = half * c->axis[a];
        m->position[m->vertex_count - 1][a] = -half * c->axis[a];
        for (int k = 0; k < AROUND; k++) {
            const double angle = 2 * PI * k / (double)AROUND;
            const double out = radius * (cos(angle) * first[a] + sin(angle) * second[a]);
            m->position[1 + k][a] = out + half * c->axis[a];
            m->position[1 + AROUND + k][a] = out - half * c->axis[a];
        }
    }
    return 0;
}

static int plane_mesh(const collider *c, const double middle[3], double reach, mesh *m) {
    double first[3], second[3], from[3];
    axes_across(c->axis, first, second);
    vector_subtract(middle, c->position, from);
    if (mesh_allocate(m, 4, 2) != 0)
        return -1;
    for (int k = 0; k < 4; k++) {
        const double u = vector_dot(from, first) + (k == 1 || k == 2 ? reach : -reach);
        const double v = vector_dot(from, second) + (k >= 2 ? reach : -reach);
        for (int a = 0; a < 3; a++)
            m->position[k][a] = u * first[a] + v * second[a];
    }
    set_triangle(m, 0, 0, 1, 2);
    set_triangle(m, 1, 0, 2, 3);
    return 0;
}

static int copy_surface(const mesh *from, mesh *m) {
    if (mesh_allocate(m, from->vertex_count, from->triangle_count) != 0)
        return -1;
    memcpy(m->position, from->position, (size_t)from->vertex_count * sizeof *m->position);
    memcpy(m->triangle, from->triangle, (size_t)from->triangle_count * sizeof *m->triangle);
    return 0;
}

int solid_mesh(const collider *c, const double middle[3], double reach, mesh *m) {
    switch (c->kind) {
    case COLLIDER_PLANE:
        return plane_mesh(c, middle, reach, m);
    case COLLIDER_BOX:
        return box_mesh(c, m);
    case COLLIDER_SPHERE:
        return sphere_mesh(c, m);
    case COLLIDER_CYLINDER:
        return cylinder_mesh(c, m);
    case COLLIDER_MESH:
        return copy_surface(surface_mesh(c->surface), m);
    }
    return -1;
}
