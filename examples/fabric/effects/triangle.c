/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Stretch and shear: the forces and their derivatives (see triangle.h for the energies). */
#include "triangle.h"

#include "../vector.h"

/* Below this |w| a direction is not to be had from w: the triangle has collapsed. */
static const double collapsed = 1e-8;

/*
 * One direction's stretch. With n = w / |w|: E's gradient in w is k a (|w| - 1) n and its second
 * derivative k a (n n' + g (I - n n')), g = 1 - 1/|w|. Under compression g < 0 and the matrix
 * would be indefinite: g is held at 0 or more. A collapsed triangle is pushed along `axis`.
 * gradient = h dE/dw; hessian = h^2 d2E/dw2 + h kd a n n'.
 */
static void stretch_terms(const double w[3], int axis, double area, double stiffness,
                          double damping, double h, double gradient[3], double hessian[3][3]) {
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
            hessian[r][c] = along * n[r] * n[c] + (r == c ? across : 0);
}

/*
 * f = the triangle's part of b, df = its part of A: blocks (i,i) (i,j) (i,k) (j,j) (j,k) (k,k).
 * Both come from derivatives in (w_u, w_v): with Q = [uu uv; uv' vv] the element's matrix is
 * A_pq = cu_p cu_q uu + cv_p cv_q vv + cu_p cv_q uv + cv_p cu_q uv'. Shear keeps the Gauss-Newton
 * part of its second derivative, which is positive semidefinite: C's gradient is (w_v; w_u).
 * Since b = h f_elastic - (h^2 K + h D) v, the damping force needs no term of its own.
 */
static void triangle_force(const triangle_rest *rest, const triangle_material *material, double h,
                           const double (*x)[3], const double (*v)[3], int i, int j, int k,
                           double f[3][3], double df[6][3][3]) {
    static const int first[6] = {0, 0, 0, 1, 1, 2};
    static const int second[6] = {0, 1, 2, 1, 2, 2};
    const double shear = h * h * material->shear + h * material->shear_damping;
    double wu[3], wv[3], vu[3], vv[3], bu[3], bv[3], uu[3][3], vvm[3][3], uv[3][3];
    double slant;
    int p, m, r, c;
    triangle_derivatives(rest, x, i, j, k, wu, wv);
    triangle_derivatives(rest, v, i, j, k, vu, vv);
    stretch_terms(wu, 0, rest->area, material->stretch, material->stretch_damping, h, bu, uu);
    stretch_terms(wv, 1, rest->area, material->stretch, material->stretch_damping, h, bv, vvm);
    slant = h * material->shear * rest->area * vector_dot(wu, wv);
    for (r = 0; r < 3; r++) {
        bu[r] += slant * wv[r];
        bv[r] += slant * wu[r];
        for (c = 0; c < 3; c++) {
            uu[r][c] += shear * rest->area * wv[r] * wv[c];
            vvm[r][c] += shear * rest->area * wu[r] * wu[c];
            uv[r][c] = shear * rest->area * wv[r] * wu[c];
        }
    }
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++) {
            bu[r] += uu[r][c] * vu[c] + uv[r][c] * vv[c];
            bv[r] += uv[c][r] * vu[c] + vvm[r][c] * vv[c];
        }
    for (p = 0; p < 3; p++)
        for (c = 0; c < 3; c++)
            f[p][c] = -(rest->cu[p] * bu[c] + rest->cv[p] * bv[c]);
    for (m = 0; m < 6; m++) {
        const double cuu = rest->cu[first[m]] * rest->cu[second[m]];
        const double cvv = rest->cv[first[m]] * rest->cv[second[m]];
        const double cuv = rest->cu[first[m]] * rest->cv[second[m]];
        const double cvu = rest->cv[first[m]] * rest->cu[second[m]];
        for (r = 0; r < 3; r++)
            for (c = 0; c < 3; c++)
                df[m][r][c] = cuu * uu[r][c] + cvv * vvm[r][c] + cuv * uv[r][c] + cvu * uv[c][r];
    }
}

void triangle_forces(const triangle_elements *e, const triangle_material *material, double h,
                     const double (*x)[3], const double (*v)[3], linear_system *s) {
    int t, i, j, k, r, c;
    int ii, ij, ik, jj, jk, kk;
    double f[3][3], df[6][3][3];
    for (t = 0; t < e->count; t++) {
        i = e->vertex[t][0];
        j = e->vertex[t][1];
        k = e->vertex[t][2];
        triangle_force(&e->rest[t], material, h, x, v, i, j, k, f, df);
        for (c = 0; c < 3; c++) {
            s->b[i][c] += f[0][c];
            s->b[j][c] += f[1][c];
            s->b[k][c] += f[2][c];
        }
        ii = e->block[t][0];
        ij = e->block[t][1];
        ik = e->block[t][2];
        jj = e->block[t][3];
        jk = e->block[t][4];
        kk = e->block[t][5];
        for (r = 0; r < 3; r++)
            for (c = 0; c < 3; c++) {
                s->A.value[ii][r][c] += df[0][r][c];
                s->A.value[ij][r][c] += df[1][r][c];
                s->A.value[ik][r][c] += df[2][r][c];
                s->A.value[jj][r][c] += df[3][r][c];
                s->A.value[jk][r][c] += df[4][r][c];
                s->A.value[kk][r][c] += df[5][r][c];
            }
    }
}
