/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "mesh_rest.h"

#include <assert.h>

#include "base/vector.h"

static double area_of(const double uv[3][2]) {
    return fabs(uv[1][0] * uv[2][1] - uv[2][0] * uv[1][1]) / 2;
}

static double longest_square(const double uv[3][2]) {
    double longest = 0;
    for (int p = 0; p < 3; p++) {
        const double *a = uv[p], *b = uv[(p + 1) % 3];
        const double square = (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
        longest = square > longest ? square : longest;
    }
    return longest;
}

/* With area a and longest edge l, height / longest edge is 2 a / l^2. */
static int is_flat(const double uv[3][2]) {
    return !(2 * area_of(uv) > MESH_LEAST_HEIGHT * longest_square(uv));
}

static void from_material(const mesh *m, const int corner[3], double uv[3][2]) {
    for (int p = 0; p < 3; p++)
        for (int a = 0; a < 2; a++)
            uv[p][a] = m->material[corner[p]][a] - m->material[corner[0]][a];
}

/* Flattens the triangle with its first edge along u; lengths and angles are those in space. */
static void from_position(const mesh *m, const int corner[3], double uv[3][2]) {
    double one[3], other[3], cross[3];
    vector_subtract(m->position[corner[1]], m->position[corner[0]], one);
    vector_subtract(m->position[corner[2]], m->position[corner[0]], other);
    vector_cross(one, other, cross);
    const double length = vector_length(one);
    uv[0][0] = uv[0][1] = uv[1][1] = 0;
    uv[1][0] = length;
    uv[2][0] = length > 0 ? vector_dot(one, other) / length : 0;
    uv[2][1] = length > 0 ? vector_length(cross) / length : 0;
}

mesh_rest_kind mesh_rest_triangle(const mesh *m, int i, int j, int k, double uv[3][2]) {
    assert(i >= 0 && i < m->vertex_count);
    assert(j >= 0 && j < m->vertex_count && k >= 0 && k < m->vertex_count);
    const int corner[3] = {i, j, k};
    double space[3][2];
    from_material(m, corner, uv);
    from_position(m, corner, space);
    const double(*flat)[2] = (const double(*)[2])uv, (*found)[2] = (const double(*)[2])space;
    if (!m->rest_in_space && !is_flat(flat) && area_of(flat) > 1e-9 * area_of(found))
        return MESH_REST_MATERIAL;
    if (is_flat(found))
        return MESH_REST_NONE;
    for (int p = 0; p < 3; p++)
        for (int a = 0; a < 2; a++)
            uv[p][a] = space[p][a];
    return MESH_REST_POSITION;
}

double mesh_rest_area(const mesh *m) {
    double sum = 0;
    for (int t = 0; t < m->triangle_count; t++) {
        const int *v = m->triangle[t];
        double uv[3][2];
        if (mesh_rest_triangle(m, v[0], v[1], v[2], uv) != MESH_REST_NONE)
            sum += area_of((const double(*)[2])uv);
    }
    return sum;
}
