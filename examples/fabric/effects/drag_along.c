/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Air drag along the cloth (see drag.h for the force). */
#include "base/vector.h"
#include "drag.h"
#include "outer_force.h"

/*
 * With the edges' cross product c = 2 a n: d = h drag (a / 3) (I - n n') is the triangle's part of
 * each of its diagonal blocks, and f[p] = d (wind - v_p) of b. A collapsed triangle has none.
 */
static void drag_force_along(const double (*x)[3], const double (*v)[3], const double wind[3],
                             int i, int j, int k, double factor, double f[3][3], double d[3][3]) {
    double one[3], other[3], cross[3], past_i[3], past_j[3], past_k[3];
    double length, scale, square;
    int r, c;
    vector_subtract(x[j], x[i], one);
    vector_subtract(x[k], x[i], other);
    vector_cross(one, other, cross);
    length = vector_length(cross);
    scale = length > 0 ? factor * length / 6 : 0;
    square = length > 0 ? 1 / (length * length) : 0;
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++)
            d[r][c] = scale * ((r == c ? 1.0 : 0.0) - square * (cross[r] * cross[c]));
    vector_subtract(wind, v[i], past_i);
    vector_subtract(wind, v[j], past_j);
    vector_subtract(wind, v[k], past_k);
    for (r = 0; r < 3; r++) {
        f[0][r] = vector_dot(d[r], past_i);
        f[1][r] = vector_dot(d[r], past_j);
        f[2][r] = vector_dot(d[r], past_k);
    }
}

void drag_forces_along(const triangle_elements *e, double drag, const double wind[3], double h,
                       const double (*restrict x)[3], const double (*restrict v)[3],
                       linear_system *s) {
    int t, i, j, k, ii, jj, kk, r, c;
    double f[3][3], d[3][3];
    for (t = 0; t < e->count; t++) {
        i = e->vertex[t][0];
        j = e->vertex[t][1];
        k = e->vertex[t][2];
        drag_force_along(x, v, wind, i, j, k, h * drag, f, d);
        for (c = 0; c < 3; c++) {
            s->b[i][c] += f[0][c];
            s->b[j][c] += f[1][c];
            s->b[k][c] += f[2][c];
        }
        ii = s->A.row_start[i];
        jj = s->A.row_start[j];
        kk = s->A.row_start[k];
        for (r = 0; r < 3; r++)
            for (c = 0; c < 3; c++) {
                s->A.value[ii][r][c] += d[r][c];
                s->A.value[jj][r][c] += d[r][c];
                s->A.value[kk][r][c] += d[r][c];
            }
    }
}

static void add(const force_target *on, const expansion *at, linear_system *s) {
    drag_forces_along(on->triangles, on->surroundings->tangential_drag, on->wind, at->h, at->x,
                      at->v, s);
}

/* Air at rest only takes. */
static double work(const force_target *on, double h, const double (*x)[3], const double (*v)[3]) {
    if (on->surroundings->tangential_drag <= 0 || vector_length(on->wind) <= 0)
        return 0;
    return drag_work_along(on->triangles, on->surroundings->tangential_drag, on->wind, h, x, v);
}

const outer_force outer_force_drag_along = {add, work};
