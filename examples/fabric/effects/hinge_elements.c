/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The hinges' rest shape, their angles and energy. */
#include "hinge.h"

#include <string.h>

#include "base/chunk_sum.h"
#include "base/vector.h"
#include "mesh/mesh_rest.h"

static const double pi = 3.14159265358979323846;

/* Returns the area of a flat triangle, and in *square its first edge's length squared. */
static double rest_area(const double uv[3][2], double *square) {
    *square = uv[1][0] * uv[1][0] + uv[1][1] * uv[1][1];
    return fabs(uv[1][0] * uv[2][1] - uv[2][0] * uv[1][1]) / 2;
}

/* Returns the weight 3 |e|^2 / a (hinge.h), or 0 if a triangle has no rest shape. */
static double rest_weight(const mesh *m, const int corner[4]) {
    double left[3][2], right[3][2], square, same;
    if (mesh_rest_triangle(m, corner[0], corner[1], corner[2], left) == MESH_REST_NONE ||
        mesh_rest_triangle(m, corner[0], corner[1], corner[3], right) == MESH_REST_NONE)
        return 0;
    const double one = rest_area((const double(*)[2])left, &square);
    const double other = rest_area((const double(*)[2])right, &same);
    return 3 * square / (one + other);
}

/* Fills `vertex` with the corners in ascending order, and role[p] with the index in `corner` of
 * vertex[p]. */
static void sort_corners(const int corner[4], int vertex[4], int role[4]) {
    for (int p = 0; p < 4; p++) {
        int at = p;
        for (; at > 0 && vertex[at - 1] > corner[p]; at--) {
            vertex[at] = vertex[at - 1];
            role[at] = role[at - 1];
        }
        vertex[at] = corner[p];
        role[at] = p;
    }
}

/* Returns the angle between the hinge's triangles, in (-pi, pi]. atan2 is accurate near 0; an arc
 * cosine would lose half the digits. */
static double hinge_angle(const double (*x)[3], const int corner[4]) {
    double e[3], a[3], b[3], n1[3], n2[3], across[3];
    vector_subtract(x[corner[1]], x[corner[0]], e);
    vector_subtract(x[corner[2]], x[corner[0]], a);
    vector_subtract(x[corner[3]], x[corner[0]], b);
    vector_cross(e, a, n1);
    vector_cross(b, e, n2);
    vector_cross(n1, n2, across);
    const double length = vector_length(e);
    return atan2(vector_dot(across, e), length * vector_dot(n1, n2));
}

int hinge_elements_init(hinge_elements *e, const mesh *m) {
    const size_t count = (size_t)m->hinge_count + 1;
    *e = (hinge_elements){0};
    e->corner = arrays_add(&e->own, count, sizeof *e->corner);
    e->vertex = arrays_add(&e->own, count, sizeof *e->vertex);
    e->role = arrays_add(&e->own, count, sizeof *e->role);
    e->weight = arrays_add(&e->own, count, sizeof *e->weight);
    e->angle = arrays_add(&e->own, count, sizeof *e->angle);
    e->at_rest = m->bent_at_rest ? arrays_add(&e->own, count, sizeof *e->at_rest) : NULL;
    if (e->own.failed) {
        hinge_elements_free(e);
        return -1;
    }
    for (int t = 0; t < m->hinge_count; t++) {
        const int n = e->count;
        e->weight[n] = rest_weight(m, m->hinge[t]);
        if (e->weight[n] <= 0)
            continue;
        for (int p = 0; p < 4; p++)
            e->corner[n][p] = m->hinge[t][p];
        if (e->at_rest)
            e->at_rest[n] = hinge_angle((const double(*)[3])m->position, e->corner[n]);
        sort_corners(e->corner[n], e->vertex[n], e->role[n]);
        e->vertices = e->vertex[n][3] >= e->vertices ? e->vertex[n][3] + 1 : e->vertices;
        e->count++;
    }
    return 0;
}

int hinge_elements_cache_angles(hinge_elements *e) {
    e->cached = arrays_add(&e->own, (size_t)e->count + 1, sizeof *e->cached);
    e->cached_x = arrays_add(&e->own, (size_t)e->vertices + 1, sizeof *e->cached_x);
    return e->own.failed ? -1 : 0;
}

int hinge_elements_place(hinge_elements *e, const block_matrix *A) {
    e->block = arrays_add(&e->own, (size_t)e->count + 1, sizeof *e->block);
    if (!e->block)
        return -1;
    const element_list list = {e->count, 4, &e->vertex[0][0]};
    block_matrix_locate(A, &list, &e->block[0][0]);
    return 0;
}

void hinge_elements_free(hinge_elements *e) {
    arrays_free(&e->own);
    *e = (hinge_elements){0};
}

/* Returns the angle of hinge t at positions x. Angles are unique up to whole rotations; the value
 * nearest to the stored angle is returned. */
static double angle_at(const hinge_elements *e, int t, const double (*x)[3]) {
    const double angle = hinge_angle(x, e->corner[t]) - (e->at_rest ? e->at_rest[t] : 0);
    const double change = e->angle[t] - angle;
    const double turns = fabs(change) > pi ? round(change / (2 * pi)) : 0;
    return angle + 2 * pi * turns;
}

void hinge_update_angles(hinge_elements *e, const double (*x)[3]) {
    const int known =
        e->has_cached && memcmp(e->cached_x, x, sizeof *e->cached_x * (size_t)e->vertices) == 0;
    e->has_cached = 0;
    if (known) {
        memcpy(e->angle, e->cached, sizeof *e->angle * (size_t)e->count);
        return;
    }
#pragma omp parallel for schedule(static)
    for (int t = 0; t < e->count; t++)
        e->angle[t] = angle_at(e, t, x);
}

double hinge_energy_at(hinge_elements *e, const hinge_material *material, const double (*x)[3]) {
    double sum[CHUNK_SUM_MOST] = {0};
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(e->count); chunk++) {
        double own = 0;
        for (int t = chunk * chunk_sum_length(e->count); t < chunk_sum_end(e->count, chunk); t++) {
            const double angle = angle_at(e, t, x);
            if (e->cached)
                e->cached[t] = angle;
            own += e->weight[t] * angle * angle;
        }
        sum[chunk] = own;
    }
    if (e->cached && e->count > 0)
        memcpy(e->cached_x, x, sizeof *e->cached_x * (size_t)e->vertices);
    e->has_cached = e->cached != NULL;
    return material->bend * chunk_sum_all(e->count, sum) / 2;
}
