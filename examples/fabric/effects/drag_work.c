/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The work of drag and wind on the cloth (see drag.h for the force). */
#include "base/chunk_sum.h"
#include "base/vector.h"
#include "drag.h"

static double work_of(const int corner[3], drag_kind kind, double factor, const double wind[3],
                      const double (*x)[3], const double (*v)[3]) {
    double cross[3], work = 0;
    vector_normal(x[corner[0]], x[corner[1]], x[corner[2]], cross);
    const double length = vector_length(cross);
    for (int p = 0; p < 3 && length > 0; p++) {
        const double *speed = v[corner[p]], along = vector_dot(cross, speed);
        double past[3];
        vector_subtract(wind, speed, past);
        if (kind == DRAG_ACROSS)
            work += factor / (6 * length) * (vector_dot(cross, wind) - along) * along;
        else
            work += factor * length / 6 *
                    (vector_dot(past, speed) - vector_dot(cross, past) / length * (along / length));
    }
    return work;
}

double drag_work(const triangle_elements *e, drag_kind kind, double drag, const double wind[3],
                 double h, const double (*x)[3], const double (*v)[3]) {
    double sum[CHUNK_SUM_MOST] = {0};
    const int count = e->count;
    if (drag <= 0 || vector_length(wind) <= 0) /* air at rest takes energy and gives none */
        return 0;
#pragma omp parallel for schedule(static)
    for (int chunk = 0; chunk < chunk_sum_chunks(count); chunk++) {
        double own = 0;
        for (int t = chunk * chunk_sum_length(count); t < chunk_sum_end(count, chunk); t++)
            own += work_of(e->vertex[t], kind, h * drag, wind, x, v);
        sum[chunk] = own;
    }
    return chunk_sum_all(count, sum);
}
