/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "crossings.h"

#include "base/vector.h"

static double volume(const double a[3], const double b[3], const double c[3], const double d[3]) {
    double ab[3], ac[3], ad[3], cross[3];
    vector_subtract(b, a, ab);
    vector_subtract(c, a, ac);
    vector_subtract(d, a, ad);
    vector_cross(ab, ac, cross);
    return vector_dot(cross, ad);
}

/* Do the boxes of segment p q and triangle a b c meet? This test is needed because rounding gives
 * the volumes of points in one plane either sign, even for distant features. */
static int boxes_meet(const double p[3], const double q[3], const double a[3], const double b[3],
                      const double c[3]) {
    for (int k = 0; k < 3; k++)
        if (fmax(p[k], q[k]) < fmin(a[k], fmin(b[k], c[k])) ||
            fmin(p[k], q[k]) > fmax(a[k], fmax(b[k], c[k])))
            return 0;
    return 1;
}

int segment_crosses(const double p[3], const double q[3], const double a[3], const double b[3],
                    const double c[3]) {
    if (!boxes_meet(p, q, a, b, c) || (volume(a, b, c, p) < 0) == (volume(a, b, c, q) < 0))
        return 0;
    const int s = volume(p, q, a, b) < 0;
    return (volume(p, q, b, c) < 0) == s && (volume(p, q, c, a) < 0) == s;
}

/* Are the triangles apart along one axis? Most pairs are. */
static int triangles_far(const int a[3], const double (*x)[3], const double of[3], const int b[3],
                         const double (*y)[3], const double at[3]) {
    for (int k = 0; k < 3; k++) {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int p = 0; p < 3; p++) {
            const double here = x[a[p]][k] + of[k], there = y[b[p]][k] + at[k];
            low[0] = here < low[0] ? here : low[0];
            high[0] = here > high[0] ? here : high[0];
            low[1] = there < low[1] ? there : low[1];
            high[1] = there > high[1] ? there : high[1];
        }
        if (high[0] < low[1] || high[1] < low[0])
            return 1;
    }
    return 0;
}

static const double unmoved[3];

int crossings(const stage *on) {
    const mesh *m = &on->m;
    const double(*x)[3] = simulation_positions(on->sim);
    int count = 0;
    for (int t = 0; t < m->triangle_count; t++)
        for (int u = 0; u < m->triangle_count; u++) {
            if (triangles_far(m->triangle[t], x, unmoved, m->triangle[u], x, unmoved))
                continue;
            for (int p = 0; p < 3; p++) {
                const int *b = m->triangle[u], i = m->triangle[t][p];
                const int j = m->triangle[t][(p + 1) % 3];
                int shared = 0;
                for (int q = 0; q < 3; q++)
                    shared += b[q] == i || b[q] == j;
                count += shared == 0 && segment_crosses(x[i], x[j], x[b[0]], x[b[1]], x[b[2]]);
            }
        }
    return count;
}

static int sides_through(const mesh *m, const double (*x)[3], const double of[3], const mesh *other,
                         const double (*y)[3], const double at[3]) {
    int count = 0;
    for (int t = 0; t < m->triangle_count; t++)
        for (int u = 0; u < other->triangle_count; u++) {
            if (triangles_far(m->triangle[t], x, of, other->triangle[u], y, at))
                continue;
            for (int p = 0; p < 3; p++) {
                double point[5][3];
                for (int a = 0; a < 3; a++) {
                    for (int k = 0; k < 2; k++)
                        point[k][a] = x[m->triangle[t][(p + k) % 3]][a] + of[a];
                    for (int k = 0; k < 3; k++)
                        point[2 + k][a] = y[other->triangle[u][k]][a] + at[a];
                }
                count += segment_crosses(point[0], point[1], point[2], point[3], point[4]);
            }
        }
    return count;
}

int crossings_with(const stage *on, const mesh *body, const double at[3]) {
    const double(*x)[3] = simulation_positions(on->sim);
    const double(*y)[3] = (const double(*)[3])body->position;
    return sides_through(&on->m, x, unmoved, body, y, at) +
           sides_through(body, y, at, &on->m, x, unmoved);
}
