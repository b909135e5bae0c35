/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Air drag and wind (see drag.h for the force). */
#include "drag.h"

#include "base/vector.h"
#include "outer_force.h"

/* Computes d = h drag (a / 3) n n', which the triangle adds to each of its diagonal blocks, and
 * f[p] = -d (v_p - wind), which it adds to b. factor = h drag, cross = 2 a n, length = |cross|. d
 * and f are 0 for a collapsed triangle. */
static void across(const double cross[3], double length, const double wind[3], double factor,
                   const double v_i[3], const double v_j[3], const double v_k[3], double f[3][3],
                   double d[3][3]) {
    const double scale = length > 0 ? factor / (6 * length) : 0;
    const double with_wind = vector_dot(cross, wind);
    const double against_i = scale * (with_wind - vector_dot(cross, v_i));
    const double against_j = scale * (with_wind - vector_dot(cross, v_j));
    const double against_k = scale * (with_wind - vector_dot(cross, v_k));
    int r, c;
    for (c = 0; c < 3; c++) {
        f[0][c] = against_i * cross[c];
        f[1][c] = against_j * cross[c];
        f[2][c] = against_k * cross[c];
    }
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++)
            d[r][c] = scale * (cross[r] * cross[c]);
}

/* Computes the terms of `across` with I - n n' in place of n n'. */
static void along(const double cross[3], double length, const double wind[3], double factor,
                  const double v_i[3], const double v_j[3], const double v_k[3], double f[3][3],
                  double d[3][3]) {
    const double scale = length > 0 ? factor * length / 6 : 0;
    const double square = length > 0 ? 1 / (length * length) : 0;
    double past_i[3], past_j[3], past_k[3];
    int r, c;
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++)
            d[r][c] = scale * ((r == c ? 1.0 : 0.0) - square * (cross[r] * cross[c]));
    vector_subtract(wind, v_i, past_i);
    vector_subtract(wind, v_j, past_j);
    vector_subtract(wind, v_k, past_k);
    for (r = 0; r < 3; r++) {
        f[0][r] = vector_dot(d[r], past_i);
        f[1][r] = vector_dot(d[r], past_j);
        f[2][r] = vector_dot(d[r], past_k);
    }
}

void drag_forces(const triangle_elements *e, drag_kind kind, double drag, const double wind[3],
                 double h, const double (*restrict x)[3], const double (*restrict v)[3],
                 linear_system *s) {
    int t, i, j, k, p, r, c;
    double cross[3], f[3][3], d[3][3];
    for (t = 0; t < e->count; t++) {
        i = e->vertex[t][0];
        j = e->vertex[t][1];
        k = e->vertex[t][2];
        vector_normal(x[i], x[j], x[k], cross);
        if (kind == DRAG_ALONG)
            along(cross, vector_length(cross), wind, h * drag, v[i], v[j], v[k], f, d);
        else
            across(cross, vector_length(cross), wind, h * drag, v[i], v[j], v[k], f, d);
        for (p = 0; p < 3; p++)
            for (c = 0; c < 3; c++)
                s->b[e->vertex[t][p]][c] += f[p][c];
        for (p = 0; p < 3; p++)
            for (r = 0; r < 3; r++)
                for (c = 0; c < 3; c++)
                    s->A.value[s->A.row_start[e->vertex[t][p]]][r][c] += d[r][c];
    }
}

static void add_across(const force_target *on, const expansion *at, linear_system *s) {
    drag_forces(on->triangles, DRAG_ACROSS, on->surroundings->drag, on->wind, at->h, at->x, at->v,
                s);
}

static void add_along(const force_target *on, const expansion *at, linear_system *s) {
    drag_forces(on->triangles, DRAG_ALONG, on->surroundings->tangential_drag, on->wind, at->h,
                at->x, at->v, s);
}

static double work_across(const force_target *on, double h, const double (*x)[3],
                          const double (*v)[3]) {
    return drag_work(on->triangles, DRAG_ACROSS, on->surroundings->drag, on->wind, h, x, v);
}

static double work_along(const force_target *on, double h, const double (*x)[3],
                         const double (*v)[3]) {
    return drag_work(on->triangles, DRAG_ALONG, on->surroundings->tangential_drag, on->wind, h, x,
                     v);
}

const outer_force outer_force_drag = {add_across, work_across};
const outer_force outer_force_drag_along = {add_along, work_along};
