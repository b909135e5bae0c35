/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Bending: the force and its derivatives (see hinge.h for the energy). */
#include "hinge.h"

#include "base/vector.h"
#include "hinge_gradient.h"

/*
 * f: the hinge's terms of b; df: those of A, blocks (i,i) (i,j) (i,k) (i,l) (j,j) (j,k) (j,l) (k,k)
 * (k,l) (l,l) of the ascending vertices. With stiffness k, damping kd and the gradient g of theta,
 * the Gauss-Newton matrix h^2 K + h D is d d', where d = sqrt(h^2 k + h kd) g. The term in theta's
 * second derivative may be indefinite and is left out.
 */
static void hinge_force(const int corner[4], const int role[4], double stiffness, double damping,
                        double angle, double h, const double (*x)[3], const double (*v)[3],
                        double f[4][3], double df[10][3][3]) {
    const double both = h * h * stiffness + h * damping;
    const double root = sqrt(both);
    double g[4][3], d[4][3];
    double rate, force;
    int p, r, c;
    hinge_gradient(x[corner[0]], x[corner[1]], x[corner[2]], x[corner[3]], g);
    rate = vector_dot(g[0], v[corner[0]]) + vector_dot(g[1], v[corner[1]]) +
           vector_dot(g[2], v[corner[2]]) + vector_dot(g[3], v[corner[3]]);
    force = -(h * stiffness * angle + both * rate);
    for (p = 0; p < 4; p++)
        for (c = 0; c < 3; c++) {
            f[p][c] = force * g[role[p]][c];
            d[p][c] = root * g[role[p]][c];
        }
    for (r = 0; r < 3; r++)
        for (c = 0; c < 3; c++) {
            df[0][r][c] = d[0][r] * d[0][c];
            df[1][r][c] = d[0][r] * d[1][c];
            df[2][r][c] = d[0][r] * d[2][c];
            df[3][r][c] = d[0][r] * d[3][c];
            df[4][r][c] = d[1][r] * d[1][c];
            df[5][r][c] = d[1][r] * d[2][c];
            df[6][r][c] = d[1][r] * d[3][c];
            df[7][r][c] = d[2][r] * d[2][c];
            df[8][r][c] = d[2][r] * d[3][c];
            df[9][r][c] = d[3][r] * d[3][c];
        }
}

void hinge_forces(const hinge_elements *e, const hinge_material *material, double h,
                  const double (*restrict x)[3], const double (*restrict v)[3], linear_system *s) {
    int t, p, r, c;
    double f[4][3], df[10][3][3];
    for (t = 0; t < e->count; t++) {
        hinge_force(e->corner[t], e->role[t], material->bend * e->weight[t],
                    material->bend_damping * e->weight[t], e->angle[t], h, x, v, f, df);
        for (p = 0; p < 4; p++)
            for (c = 0; c < 3; c++)
                s->b[e->vertex[t][p]][c] += f[p][c];
        /* Two loops, because ten blocks at once need more addresses than there are registers. */
        for (r = 0; r < 3; r++)
            for (c = 0; c < 3; c++) {
                s->A.value[e->block[t][0]][r][c] += df[0][r][c];
                s->A.value[e->block[t][1]][r][c] += df[1][r][c];
                s->A.value[e->block[t][2]][r][c] += df[2][r][c];
                s->A.value[e->block[t][3]][r][c] += df[3][r][c];
                s->A.value[e->block[t][4]][r][c] += df[4][r][c];
            }
        for (r = 0; r < 3; r++)
            for (c = 0; c < 3; c++) {
                s->A.value[e->block[t][5]][r][c] += df[5][r][c];
                s->A.value[e->block[t][6]][r][c] += df[6][r][c];
                s->A.value[e->block[t][7]][r][c] += df[7][r][c];
                s->A.value[e->block[t][8]][r][c] += df[8][r][c];
                s->A.value[e->block[t][9]][r][c] += df[9][r][c];
            }
    }
}
