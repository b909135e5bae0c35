/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The list of limited triangles, and their energy. */
#include "base/chunk_sum.h"
#include "base/vector.h"
#include "strain_limit.h"

int strain_limit_init(strain_limit *l, const triangle_elements *e, double limit, double stretch) {
    *l = (strain_limit){.limit = limit, .stiffness = STRAIN_LIMIT_FACTOR * stretch};
    l->triangle = arrays_add(&l->own, (size_t)e->count + 1, sizeof *l->triangle);
    l->over = arrays_add(&l->own, (size_t)e->count + 1, sizeof *l->over);
    return l->own.failed ? -1 : 0;
}

void strain_limit_free(strain_limit *l) {
    arrays_free(&l->own);
    *l = (strain_limit){0};
}

static void lengths(const triangle_elements *e, int t, const double (*x)[3], double length[2]) {
    const int *corner = e->vertex[t];
    double wu[3], wv[3];
    triangle_derivatives(&e->rest[t], x, corner[0], corner[1], corner[2], wu, wv);
    length[0] = vector_length(wu);
    length[1] = vector_length(wv);
}

static void list(strain_limit *l, int count) {
    l->count = 0;
    for (int t = 0; t < count; t++)
        if (l->over[t] != 0)
            l->triangle[l->count++] = t;
}

void strain_limit_find(strain_limit *l, const triangle_elements *e, const double (*x)[3]) {
#pragma omp parallel for schedule(static)
    for (int t = 0; t < e->count; t++) {
        double length[2];
        lengths(e, t, x, length);
        l->over[t] = (unsigned char)((length[0] > 1 + l->limit) | (length[1] > 1 + l->limit) << 1);
    }
    list(l, e->count);
}

/* Computes |w_u| and |w_v| of triangle t after h s with velocities v + dv. */
static void later_lengths(const triangle_elements *e, int t, double h, const double (*x)[3],
                          const double (*v)[3], const double (*dv)[3], double length[2]) {
    const int *corner = e->vertex[t];
    double end[3][3], wu[3], wv[3];
    for (int p = 0; p < 3; p++)
        for (int a = 0; a < 3; a++)
            end[p][a] = x[corner[p]][a] + h * (v[corner[p]][a] + dv[corner[p]][a]);
    triangle_derivatives(&e->rest[t], (const double(*)[3])end, 0, 1, 2, wu, wv);
    length[0] = vector_length(wu);
    length[1] = vector_length(wv);
}

int strain_limit_find_missed(strain_limit *l, const triangle_elements *e, double h,
                             const double (*x)[3], const double (*v)[3], const double (*dv)[3]) {
    l->count = 0;
    /* Starts a new list, because the old list's triangles are already in the system. */
    for (int t = 0; t < e->count; t++) {
        double length[2];
        if (l->over[t] != 0)
            continue;
        later_lengths(e, t, h, x, v, dv, length);
        l->over[t] = (unsigned char)((length[0] > 1 + l->limit) | (length[1] > 1 + l->limit) << 1);
        if (l->over[t] != 0)
            l->triangle[l->count++] = t;
    }
    return l->count;
}

double strain_limit_energy(const strain_limit *l, const triangle_elements *e,
                           const double (*x)[3]) {
    double sum[CHUNK_SUM_MOST] = {0};
    const int count = e->count;
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        for (int t = chunk * chunk_sum_length(count); t < chunk_sum_end(count, chunk); t++) {
            double length[2];
            lengths(e, t, x, length);
            for (int a = 0; a < 2; a++) {
                const double over = length[a] - 1 - l->limit;
                sum[chunk] += over > 0 ? e->rest[t].area * over * over : 0;
            }
        }
    return l->stiffness * chunk_sum_all(count, sum) / 2;
}
