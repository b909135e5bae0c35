/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Damping forces (see triangle.h and hinge.h): f = -kd dC (dC . v) for each condition C and its
 * damping coefficient kd. */
#include "hinge.h"
#include "hinge_gradient.h"
#include "triangle.h"

/* Computes the unit direction n of w, or the coordinate axis `axis` if the triangle has collapsed,
 * as in triangle_terms.h. */
static inline void direction(const double w[3], int axis, double n[3]) {
    const double length = vector_length(w);
    const int usable = length > 1e-8;
    int c;
    for (c = 0; c < 3; c++)
        n[c] = usable ? w[c] / length : (c == axis ? 1.0 : 0.0);
}

static void triangle_damping(const triangle_rest *rest, const triangle_material *material, double h,
                             const double (*x)[3], const double (*v)[3], int i, int j, int k,
                             double f[3][3]) {
    const double along = h * material->stretch_damping * rest->area;
    const double across = h * material->shear_damping * rest->area;
    double wu[3], wv[3], rate_u[3], rate_v[3], nu[3], nv[3];
    double speed_u, speed_v, slant;
    int p, c;
    triangle_derivatives(rest, x, i, j, k, wu, wv);
    triangle_derivatives(rest, v, i, j, k, rate_u, rate_v);
    direction(wu, 0, nu);
    direction(wv, 1, nv);
    speed_u = along * vector_dot(nu, rate_u);
    speed_v = along * vector_dot(nv, rate_v);
    slant = across * (vector_dot(wv, rate_u) + vector_dot(wu, rate_v));
    for (p = 0; p < 3; p++)
        for (c = 0; c < 3; c++)
            f[p][c] = -(rest->cu[p] * (speed_u * nu[c] + slant * wv[c]) +
                        rest->cv[p] * (speed_v * nv[c] + slant * wu[c]));
}

void triangle_damping_forces(const triangle_elements *e, const triangle_material *material,
                             double h, const double (*restrict x)[3], const double (*restrict v)[3],
                             double (*restrict b)[3]) {
    int t, p, c;
    double f[3][3];
    for (t = 0; t < e->count; t++) {
        triangle_damping(&e->rest[t], material, h, x, v, e->vertex[t][0], e->vertex[t][1],
                         e->vertex[t][2], f);
        for (p = 0; p < 3; p++)
            for (c = 0; c < 3; c++)
                b[e->vertex[t][p]][c] += f[p][c];
    }
}

void hinge_damping_forces(const hinge_elements *e, const hinge_material *material, double h,
                          const double (*restrict x)[3], const double (*restrict v)[3],
                          double (*restrict b)[3]) {
    int t, p, c;
    double rate;
    double g[4][3];
    for (t = 0; t < e->count; t++) {
        const int *at = e->corner[t];
        hinge_gradient(x[at[0]], x[at[1]], x[at[2]], x[at[3]], g);
        rate = vector_dot(g[0], v[at[0]]) + vector_dot(g[1], v[at[1]]) +
               vector_dot(g[2], v[at[2]]) + vector_dot(g[3], v[at[3]]);
        rate = -h * material->bend_damping * e->weight[t] * rate;
        for (p = 0; p < 4; p++)
            for (c = 0; c < 3; c++)
                b[e->corner[t][p]][c] += rate * g[p][c];
    }
}
