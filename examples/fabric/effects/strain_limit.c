/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Strain limiting: the force and its derivative (see strain_limit.h for the energy). */
#include "strain_limit.h"

#include "base/vector.h"

/*
 * The terms of one direction w. With n = w / |w|, b = rest_length = 1 + limit, stiffness k and area
 * a, the gradient is h dE/dw = h k a (|w| - b) n. The Hessian is h^2 k a (n n' + g (I - n n')), g =
 * max(0, 1 - b / |w|). `on` is 1 if this direction is limited, otherwise 0.
 */
static inline void limit_terms(const double w[3], double on, double rest_length, double area,
                               double stiffness, double h, double gradient[3],
                               double hessian[3][3]) {
    const double length = vector_length(w);
    const double inverse = length > 0 ? 1 / length : 0;
    const double g = length > rest_length ? 1 - rest_length * inverse : 0;
    const double along = on * h * h * stiffness * area;
    const double force = on * h * stiffness * area * (length - rest_length) * inverse;
    int r, c;
    for (r = 0; r < 3; r++) {
        gradient[r] = force * w[r];
        for (c = 0; c < 3; c++)
            hessian[r][c] =
                along * ((1 - g) * (inverse * w[r]) * (inverse * w[c]) + (r == c ? g : 0));
    }
}

/* Computes f and df as triangle_force does, without shear; df has the blocks (i,i) (i,j) (i,k)
 * (j,j) (j,k) (k,k). */
static void limit_force(const triangle_rest *rest, unsigned over, double rest_length,
                        double stiffness, double h, const double (*x)[3], const double (*v)[3],
                        int i, int j, int k, double f[3][3], double df[6][3][3]) {
    const double u0 = rest->cu[0], u1 = rest->cu[1], u2 = rest->cu[2];
    const double v0 = rest->cv[0], v1 = rest->cv[1], v2 = rest->cv[2];
    double wu[3], wv[3], rate_u[3], rate_v[3], force_u[3], force_v[3], uu[3][3], vv[3][3];
    int p, r, c;
    triangle_derivatives(rest, x, i, j, k, wu, wv);
    triangle_derivatives(rest, v, i, j, k, rate_u, rate_v);
    limit_terms(wu, (over & 1u) != 0 ? 1 : 0, rest_length, rest->area, stiffness, h, force_u, uu);
    limit_terms(wv, (over & 2u) != 0 ? 1 : 0, rest_length, rest->area, stiffness, h, force_v, vv);
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++) {
            force_u[r] += uu[r][c] * rate_u[c];
            force_v[r] += vv[r][c] * rate_v[c];
            df[0][r][c] = u0 * u0 * uu[r][c] + v0 * v0 * vv[r][c];
            df[1][r][c] = u0 * u1 * uu[r][c] + v0 * v1 * vv[r][c];
            df[2][r][c] = u0 * u2 * uu[r][c] + v0 * v2 * vv[r][c];
            df[3][r][c] = u1 * u1 * uu[r][c] + v1 * v1 * vv[r][c];
            df[4][r][c] = u1 * u2 * uu[r][c] + v1 * v2 * vv[r][c];
            df[5][r][c] = u2 * u2 * uu[r][c] + v2 * v2 * vv[r][c];
        }
    for (p = 0; p < 3; p++)
        for (c = 0; c < 3; c++)
            f[p][c] = -(rest->cu[p] * force_u[c] + rest->cv[p] * force_v[c]);
}

void strain_limit_forces(const strain_limit *l, const triangle_elements *e, double h,
                         const double (*restrict x)[3], const double (*restrict v)[3],
                         linear_system *s) {
    int n, t, p, r, c;
    double f[3][3], df[6][3][3];
    for (n = 0; n < l->count; n++) {
        t = l->triangle[n];
        limit_force(&e->rest[t], l->over[t], 1 + l->limit, l->stiffness, h, x, v, e->vertex[t][0],
                    e->vertex[t][1], e->vertex[t][2], f, df);
        for (p = 0; p < 3; p++)
            for (c = 0; c < 3; c++)
                s->b[e->vertex[t][p]][c] += f[p][c];
        for (p = 0; p < 6; p++)
            for (r = 0; r < 3; r++)
                for (c = 0; c < 3; c++)
                    s->A.value[e->block[t][p]][r][c] += df[p][r][c];
    }
}
