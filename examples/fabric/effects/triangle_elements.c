/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The triangles' rest shape, their block indices in A, energies and strain. */
#include "triangle.h"

#include "base/chunk_sum.h"
#include "base/vector.h"
#include "mesh/mesh_rest.h"

static void sort_three(const int in[3], int out[3]) {
    const int low = in[0] < in[1] ? in[0] : in[1];
    const int high = in[0] < in[1] ? in[1] : in[0];
    out[0] = in[2] < low ? in[2] : low;
    out[2] = in[2] > high ? in[2] : high;
    out[1] = in[2] < low ? low : (in[2] > high ? high : in[2]);
}

/* Computes cu and cv, the inverse of the flat triangle's edge matrix. Returns 0 if the triangle has
 * no rest shape, otherwise 1. */
static int rest_shape(const mesh *m, const int vertex[3], triangle_rest *rest) {
    double uv[3][2];
    if (mesh_rest_triangle(m, vertex[0], vertex[1], vertex[2], uv) == MESH_REST_NONE)
        return 0;
    const double u1 = uv[1][0], v1 = uv[1][1];
    const double u2 = uv[2][0], v2 = uv[2][1];
    const double determinant = u1 * v2 - u2 * v1;
    rest->cu[1] = v2 / determinant;
    rest->cu[2] = -v1 / determinant;
    rest->cu[0] = -(rest->cu[1] + rest->cu[2]);
    rest->cv[1] = -u2 / determinant;
    rest->cv[2] = u1 / determinant;
    rest->cv[0] = -(rest->cv[1] + rest->cv[2]);
    rest->area = fabs(determinant) / 2;
    return 1;
}

int triangle_elements_init(triangle_elements *e, const mesh *m) {
    *e = (triangle_elements){0};
    e->vertex = arrays_add(&e->own, (size_t)m->triangle_count + 1, sizeof *e->vertex);
    e->rest = arrays_add(&e->own, (size_t)m->triangle_count + 1, sizeof *e->rest);
    if (e->own.failed) {
        triangle_elements_free(e);
        return -1;
    }
    for (int t = 0; t < m->triangle_count; t++) {
        sort_three(m->triangle[t], e->vertex[e->count]);
        e->count += rest_shape(m, e->vertex[e->count], &e->rest[e->count]);
    }
    return 0;
}

int triangle_elements_place(triangle_elements *e, const block_matrix *A) {
    e->block = arrays_add(&e->own, (size_t)e->count + 1, sizeof *e->block);
    if (!e->block)
        return -1;
    const element_list list = {e->count, 3, &e->vertex[0][0]};
    block_matrix_locate(A, &list, &e->block[0][0]);
    return 0;
}

void triangle_elements_free(triangle_elements *e) {
    arrays_free(&e->own);
    *e = (triangle_elements){0};
}

void triangle_energies(const triangle_elements *e, const triangle_material *material,
                       const double (*x)[3], double *stretch, double *shear) {
    double along[CHUNK_SUM_MOST] = {0}, slanted[CHUNK_SUM_MOST] = {0};
    const int count = e->count;
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++) {
        double own_along = 0, own_slanted = 0;
        for (int t = chunk * chunk_sum_length(count); t < chunk_sum_end(count, chunk); t++) {
            double wu[3], wv[3];
            triangle_derivatives(&e->rest[t], x, e->vertex[t][0], e->vertex[t][1], e->vertex[t][2],
                                 wu, wv);
            const double u = vector_length(wu) - 1, v = vector_length(wv) - 1;
            const double s = vector_dot(wu, wv);
            own_along += e->rest[t].area * (u * u + v * v);
            own_slanted += e->rest[t].area * s * s;
        }
        along[chunk] = own_along;
        slanted[chunk] = own_slanted;
    }
    if (stretch)
        *stretch = material->stretch * chunk_sum_all(count, along) / 2;
    if (shear)
        *shear = material->shear * chunk_sum_all(count, slanted) / 2;
}

double triangle_greatest_strain(const triangle_elements *e, const double (*x)[3]) {
    double greatest = -1;
    int broken = 0;
#pragma omp parallel for schedule(static) reduction(max : greatest, broken)
    for (int t = 0; t < e->count; t++) {
        double wu[3], wv[3];
        triangle_derivatives(&e->rest[t], x, e->vertex[t][0], e->vertex[t][1], e->vertex[t][2], wu,
                             wv);
        const double u = vector_length(wu) - 1, v = vector_length(wv) - 1;
        const double larger = u > v ? u : v;
        if (!isfinite(u) || !isfinite(v))
            broken = 1;
        if (larger > greatest)
            greatest = larger;
    }
    return broken ? NAN : greatest;
}
