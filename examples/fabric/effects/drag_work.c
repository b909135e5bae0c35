/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* What wind gives to the cloth (see drag.h for the force). */
#include "base/chunk_sum.h"
#include "base/vector.h"
#include "drag.h"

/* The triangle's normal, twice its area long; returns that length. */
static double normal_of(const int corner[3], const double (*x)[3], double cross[3]) {
    double one[3], other[3];
    vector_subtract(x[corner[1]], x[corner[0]], one);
    vector_subtract(x[corner[2]], x[corner[0]], other);
    vector_cross(one, other, cross);
    return vector_length(cross);
}

static double work_of(const int corner[3], double factor, const double wind[3],
                      const double (*x)[3], const double (*v)[3]) {
    double cross[3], work = 0;
    const double length = normal_of(corner, x, cross);
    for (int p = 0; p < 3 && length > 0; p++) {
        const double along = vector_dot(cross, v[corner[p]]);
        work += factor / (6 * length) * (vector_dot(cross, wind) - along) * along;
    }
    return work;
}

static double work_along_of(const int corner[3], double factor, const double wind[3],
                            const double (*x)[3], const double (*v)[3]) {
    double cross[3], work = 0;
    const double length = normal_of(corner, x, cross);
    for (int p = 0; p < 3 && length > 0; p++) {
        double past[3];
        vector_subtract(wind, v[corner[p]], past);
        const double across = vector_dot(cross, past) / length;
        const double along = vector_dot(cross, v[corner[p]]) / length;
        work += factor * length / 6 * (vector_dot(past, v[corner[p]]) - across * along);
    }
    return work;
}

typedef double corner_work(const int corner[3], double factor, const double wind[3],
                           const double (*x)[3], const double (*v)[3]);

static double sum_up(corner_work *work_of_one, const triangle_elements *e, double factor,
                     const double wind[3], const double (*x)[3], const double (*v)[3]) {
    double sum[CHUNK_SUM_MOST] = {0};
    const int count = e->count;
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++)
        for (int t = chunk * chunk_sum_length(count); t < chunk_sum_end(count, chunk); t++)
            sum[chunk] += work_of_one(e->vertex[t], factor, wind, x, v);
    return chunk_sum_all(count, sum);
}

double drag_work(const triangle_elements *e, double drag, const double wind[3], double h,
                 const double (*x)[3], const double (*v)[3]) {
    return sum_up(work_of, e, h * drag, wind, x, v);
}

double drag_work_along(const triangle_elements *e, double drag, const double wind[3], double h,
                       const double (*x)[3], const double (*v)[3]) {
    return sum_up(work_along_of, e, h * drag, wind, x, v);
}
