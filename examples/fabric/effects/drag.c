/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Air drag and wind (see drag.h for the force). */
#include "drag.h"

#include "base/vector.h"
#include "outer_force.h"

/*
 * With the edges' cross product 2 a n: d = h drag (a / 3) n n' is the triangle's part of each of
 * its diagonal blocks, and f[p] = -d (v_p - wind) of b. Both are 0 for a collapsed triangle.
 */
static void drag_force(const double (*x)[3], const double (*v)[3], const double wind[3], int i,
                       int j, int k, double factor, double f[3][3], double d[3][3]) {
    double one[3], other[3], cross[3];
    double length, scale, against_i, against_j, against_k, with_wind;
    int r, c;
    vector_subtract(x[j], x[i], one);
    vector_subtract(x[k], x[i], other);
    vector_cross(one, other, cross);
    length = vector_length(cross);
    scale = length > 0 ? factor / (6 * length) : 0;
    with_wind = vector_dot(cross, wind);
    against_i = scale * (with_wind - vector_dot(cross, v[i]));
    against_j = scale * (with_wind - vector_dot(cross, v[j]));
    against_k = scale * (with_wind - vector_dot(cross, v[k]));
    for (c = 0; c < 3; c++) {
        f[0][c] = against_i * cross[c];
        f[1][c] = against_j * cross[c];
        f[2][c] = against_k * cross[c];
    }
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++)
            d[r][c] = scale * (cross[r] * cross[c]);
}

void drag_forces(const triangle_elements *e, double drag, const double wind[3], double h,
                 const double (*restrict x)[3], const double (*restrict v)[3], linear_system *s) {
    int t, i, j, k, ii, jj, kk, r, c;
    double f[3][3], d[3][3];
    for (t = 0; t < e->count; t++) {
        i = e->vertex[t][0];
        j = e->vertex[t][1];
        k = e->vertex[t][2];
        drag_force(x, v, wind, i, j, k, h * drag, f, d);
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
    drag_forces(on->triangles, on->surroundings->drag, on->wind, at->h, at->x, at->v, s);
}

/* Air at rest only takes. */
static double work(const force_target *on, double h, const double (*x)[3], const double (*v)[3]) {
    if (on->surroundings->drag <= 0 || vector_length(on->wind) <= 0)
        return 0;
    return drag_work(on->triangles, on->surroundings->drag, on->wind, h, x, v);
}

const outer_force outer_force_drag = {add, work};
