/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One triangle's stretch and shear: the force and its derivatives (triangle.h has the energies).
 * The argument `effects` of triangle_force is a constant at each call, so that the compiler removes
 * the terms of other effects.
 */
#ifndef FABRIC_TRIANGLE_TERMS_H
#define FABRIC_TRIANGLE_TERMS_H

#include "base/vector.h"
#include "triangle.h"

/** The effects in a triangle, each together with its damping. */
enum { TRIANGLE_STRETCH = 1, TRIANGLE_SHEAR = 2 };

#if defined(__GNUC__)
#define TRIANGLE_INLINE static inline __attribute__((always_inline))
#else
#define TRIANGLE_INLINE static inline
#endif

/* Below this |w| the triangle has collapsed, and w has no usable direction. */
static const double collapsed = 1e-8;

/*
 * Stretch in one direction w. With n = w / |w|, stiffness k, damping kd and area a, the gradient of
 * E with respect to w is k a (|w| - 1) n, and the second derivative k a (n n' + g (I - n n')), g =
 * 1 - 1/|w|. Under compression g < 0 would make the matrix indefinite, so negative g is replaced by
 * 0. A collapsed triangle is pushed along `axis`.
 *     gradient = h dE/dw,  hessian = h^2 d2E/dw2 + h kd a n n'
 */
TRIANGLE_INLINE void stretch_terms(const double w[3], int axis, double area, double stiffness,
                                   double damping, double h, double gradient[3],
                                   double hessian[3][3]) {
    const double length = vector_length(w);
    const int usable = length > collapsed;
    const double inverse = usable ? 1 / length : 0;
    const double g = length > 1 ? 1 - inverse : 0;
    const double across = h * h * stiffness * area * g;
    const double along = (h * h * stiffness + h * damping) * area - across;
    double n[3];
    int r, c;
    for (c = 0; c < 3; c++) {
        n[c] = usable ? w[c] * inverse : (c == axis ? 1.0 : 0.0);
        gradient[c] = h * stiffness * area * (length - 1) * n[c];
    }
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++)
            hessian[r][c] = along * (n[r] * n[c]) + (r == c ? across : 0);
}

/*
 * Shear uses only the Gauss-Newton part of its second derivative, which is positive semidefinite.
 * The gradient of C with respect to (w_u; w_v) is sqrt(a) (w_v; w_u). With step h, stiffness k,
 * damping kd and area a, the arguments are shear = (h^2 k + h kd) a and slant = h k a w_u . w_v.
 * Adds to the gradients h dE/dw_u and h dE/dw_v and to the blocks uu and vv, or sets them if
 * `alone`. Sets uv.
 */
TRIANGLE_INLINE void shear_terms(int alone, const double wu[3], const double wv[3], double shear,
                                 double slant, double force_u[3], double force_v[3],
                                 double uu[3][3], double vv[3][3], double uv[3][3]) {
    int r, c;
    for (r = 0; r < 3; r++) {
        force_u[r] = alone ? slant * wv[r] : force_u[r] + slant * wv[r];
        force_v[r] = alone ? slant * wu[r] : force_v[r] + slant * wu[r];
        for (c = 0; c < 3; c++) {
            const double in_u = shear * (wv[r] * wv[c]), in_v = shear * (wu[r] * wu[c]);
            uu[r][c] = alone ? in_u : uu[r][c] + in_u;
            vv[r][c] = alone ? in_v : vv[r][c] + in_v;
            uv[r][c] = shear * wv[r] * wu[c];
        }
    }
}

/*
 * f: the triangle's terms of b; df: those of A, blocks (i,i) (i,j) (i,k) (j,j) (j,k) (k,k). Both
 * come from derivatives with respect to (w_u, w_v). With their matrix [uu uv; uv' vv], block (p,q)
 * of the triangle is A_pq = cu_p cu_q uu + cv_p cv_q vv + cu_p cv_q uv + cv_p cu_q uv'. The
 * coefficients cu and cv sum to 0, and so does each row of blocks: the blocks of i follow from
 * (j,j), (j,k) and (k,k). Without shear, uv is 0. With the stiffness and damping matrices K and D,
 * b = h f_elastic - (h^2 K + h D) v, so damping needs no separate term in f.
 */
TRIANGLE_INLINE void triangle_force(int effects, const triangle_rest *rest,
                                    const triangle_material *material, double h,
                                    const double (*x)[3], const double (*v)[3], int i, int j, int k,
                                    double f[3][3], double df[6][3][3]) {
    const double u1 = rest->cu[1], u2 = rest->cu[2], v1 = rest->cv[1], v2 = rest->cv[2];
    double wu[3], wv[3], rate_u[3], rate_v[3], force_u[3], force_v[3];
    double uu[3][3], vv[3][3], uv[3][3];
    double shear, slant;
    int p, r, c;
    triangle_derivatives(rest, x, i, j, k, wu, wv);
    triangle_derivatives(rest, v, i, j, k, rate_u, rate_v);
    if ((effects & TRIANGLE_STRETCH) != 0) {
        stretch_terms(wu, 0, rest->area, material->stretch, material->stretch_damping, h, force_u,
                      uu);
        stretch_terms(wv, 1, rest->area, material->stretch, material->stretch_damping, h, force_v,
                      vv);
    }
    shear = (h * h * material->shear + h * material->shear_damping) * rest->area;
    slant = h * material->shear * rest->area * vector_dot(wu, wv);
    if ((effects & TRIANGLE_SHEAR) != 0)
        shear_terms((effects & TRIANGLE_STRETCH) == 0, wu, wv, shear, slant, force_u, force_v, uu,
                    vv, uv);
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++) {
            if ((effects & TRIANGLE_SHEAR) != 0) {
                force_u[r] += uu[r][c] * rate_u[c] + uv[r][c] * rate_v[c];
                force_v[r] += uv[c][r] * rate_u[c] + vv[r][c] * rate_v[c];
            } else {
                force_u[r] += uu[r][c] * rate_u[c];
                force_v[r] += vv[r][c] * rate_v[c];
            }
        }
    for (p = 0; p < 3; p++)
        for (c = 0; c < 3; c++)
            f[p][c] = -(rest->cu[p] * force_u[c] + rest->cv[p] * force_v[c]);
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++) {
            df[3][r][c] = u1 * u1 * uu[r][c] + v1 * v1 * vv[r][c];
            df[4][r][c] = u1 * u2 * uu[r][c] + v1 * v2 * vv[r][c];
            df[5][r][c] = u2 * u2 * uu[r][c] + v2 * v2 * vv[r][c];
            if ((effects & TRIANGLE_SHEAR) != 0) {
                const double both = uv[r][c] + uv[c][r];
                df[3][r][c] += u1 * v1 * both;
                df[4][r][c] += u1 * v2 * uv[r][c];
                df[4][r][c] += v1 * u2 * uv[c][r];
                df[5][r][c] += u2 * v2 * both;
            }
        }
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++) {
            df[0][r][c] = (df[3][r][c] + df[5][r][c]) + (df[4][r][c] + df[4][c][r]);
            df[1][r][c] = -(df[3][r][c] + df[4][c][r]);
            df[2][r][c] = -(df[4][r][c] + df[5][r][c]);
        }
}

#endif
