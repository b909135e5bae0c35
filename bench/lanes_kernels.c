/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The loops of bench/lanes, as they are in users' programs. redcc translates them; for comparison
 * they are also compiled unchanged. */
#include <math.h>

#include "lanes_kernels.h"

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Computes w, the derivative of a triangle's position with respect to the material coordinate u or
 * v: the sum of share[p] x[p] over its corners p. */
static void along(const double (*x)[3], int i, int j, int k, const double share[3], double w[3]) {
    for (int c = 0; c < 3; c++)
        w[c] = share[0] * x[i][c] + share[1] * x[j][c] + share[2] * x[k][c];
}

/* Stretch and shear with damping: forces -k C dC/dx - d C' dC/dx of conditions C, with their rates
 * C', stiffness k and damping d (Baraff and Witkin 1998, section 4). */
static void compute_force(const double (*x)[3], const double (*v)[3], int i, int j, int k,
                          const double u_share[3], const double v_share[3], double area,
                          double f[3][3]) {
    double wu[3], wv[3], rate_u[3], rate_v[3];
    along(x, i, j, k, u_share, wu);
    along(x, i, j, k, v_share, wv);
    along(v, i, j, k, u_share, rate_u);
    along(v, i, j, k, v_share, rate_v);
    const double u_length = sqrt(dot(wu, wu)), v_length = sqrt(dot(wv, wv));
    const double stretch_u =
        40.0 * area * (u_length - 1.0) + 0.2 * area * dot(wu, rate_u) / u_length;
    const double stretch_v =
        40.0 * area * (v_length - 1.0) + 0.2 * area * dot(wv, rate_v) / v_length;
    const double shear =
        15.0 * area * dot(wu, wv) + 0.1 * area * (dot(wu, rate_v) + dot(rate_u, wv));
    for (int p = 0; p < 3; p++)
        for (int c = 0; c < 3; c++)
            f[p][c] = -area * (stretch_u * u_share[p] * wu[c] / u_length +
                               stretch_v * v_share[p] * wv[c] / v_length +
                               shear * (u_share[p] * wv[c] + v_share[p] * wu[c]));
}

/* Computes the derivatives of compute_force's forces with respect to the corners' positions and
 * velocities, as an implicit step needs them. */
static void compute_derivatives(const double (*x)[3], int i, int j, int k, const double u_share[3],
                                const double v_share[3], double area, double df[3][3][3][3]) {
    double wu[3], wv[3], nu[3], nv[3];
    along(x, i, j, k, u_share, wu);
    along(x, i, j, k, v_share, wv);
    const double u_length = sqrt(dot(wu, wu)), v_length = sqrt(dot(wv, wv));
    const double stretch_u = 40.0 * area * (u_length - 1.0) / u_length;
    const double stretch_v = 40.0 * area * (v_length - 1.0) / v_length;
    const double shear = 15.0 * area * dot(wu, wv);
    for (int c = 0; c < 3; c++) {
        nu[c] = wu[c] / u_length;
        nv[c] = wv[c] / v_length;
    }
    for (int p = 0; p < 3; p++)
        for (int q = 0; q < 3; q++) {
            const double uu = u_share[p] * u_share[q], vv = v_share[p] * v_share[q];
            const double uv = u_share[p] * v_share[q] + v_share[p] * u_share[q];
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++) {
                    const double unit = r == c ? 1.0 : 0.0;
                    const double in_p = u_share[p] * wv[r] + v_share[p] * wu[r];
                    const double in_q = u_share[q] * wv[c] + v_share[q] * wu[c];
                    df[p][q][r][c] =
                        -area * (uu * (stretch_u * (unit - nu[r] * nu[c]) +
                                       (40.0 + 0.2) * area * nu[r] * nu[c]) +
                                 vv * (stretch_v * (unit - nv[r] * nv[c]) +
                                       (40.0 + 0.2) * area * nv[r] * nv[c]) +
                                 (15.0 + 0.1) * area * in_p * in_q + shear * uv * unit);
                }
        }
}

/* Forces of a cloth's triangles, and all blocks of the matrix: 90 updates per triangle. */
void cloth(int count, const struct cloth_element *restrict element, const double (*restrict x)[3],
           const double (*restrict v)[3], double (*b)[3], double (*a)[3][3]) {
    for (int t = 0; t < count; t++) {
        const int i = element[t].vertex[0], j = element[t].vertex[1], k = element[t].vertex[2];
        double f[3][3], df[3][3][3][3];
        compute_force(x, v, i, j, k, element[t].u, element[t].v, element[t].area, f);
        compute_derivatives(x, i, j, k, element[t].u, element[t].v, element[t].area, df);
        for (int c = 0; c < 3; c++) {
            b[i][c] += f[0][c];
            b[j][c] += f[1][c];
            b[k][c] += f[2][c];
        }
        for (int p = 0; p < 3; p++)
            for (int q = 0; q < 3; q++)
                for (int r = 0; r < 3; r++)
                    for (int c = 0; c < 3; c++)
                        a[element[t].entry[p][q]][r][c] += df[p][q][r][c];
    }
}

/* Adds the forces of one strain of a triangle, along u or v, to f and their derivatives to df. The
 * length of the sum of weight[a] x[a] is 1 at rest. */
static void strain(const double (*x)[3], int i, int j, int k, const double weight[3], double area,
                   double f[3][3], double df[6][3][3]) {
    double w[3], n[3];
    for (int c = 0; c < 3; c++)
        w[c] = weight[0] * x[i][c] + weight[1] * x[j][c] + weight[2] * x[k][c];
    const double length = sqrt(dot(w, w));
    for (int c = 0; c < 3; c++)
        n[c] = w[c] / length;
    const double excess = area * (length - 1.0);
    int pair = 0;
    for (int p = 0; p < 3; p++) {
        for (int c = 0; c < 3; c++)
            f[p][c] -= 40.0 * excess * area * weight[p] * n[c];
        for (int q = p; q < 3; q++) {
            const double both = 40.0 * area * weight[p] * weight[q];
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++) {
                    const double across = (r == c ? 1.0 : 0.0) - n[r] * n[c];
                    df[pair][r][c] -= both * (area * n[r] * n[c] + excess / length * across);
                }
            pair++;
        }
    }
}

/* Forces of a cloth's triangles, and their derivatives: the upper half of a matrix of blocks. */
void membrane(int count, const struct element *restrict element, const double (*restrict x)[3],
              double (*b)[3], double (*a)[3][3]) {
    for (int t = 0; t < count; t++) {
        const int i = element[t].vertex[0], j = element[t].vertex[1], k = element[t].vertex[2];
        double f[3][3] = {{0}}, df[6][3][3] = {{{0}}};
        strain(x, i, j, k, element[t].u, element[t].area, f, df);
        strain(x, i, j, k, element[t].v, element[t].area, f, df);
        for (int c = 0; c < 3; c++) {
            b[i][c] += f[0][c];
            b[j][c] += f[1][c];
            b[k][c] += f[2][c];
        }
        for (int q = 0; q < 6; q++)
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++)
                    a[element[t].block[q]][r][c] += df[q][r][c];
    }
}

static float float_dot(const float a[3], const float b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void float_strain(const float (*x)[3], int i, int j, int k, const double weight[3],
                         double area, float f[3][3]) {
    const float of[3] = {weight[0], weight[1], weight[2]};
    const float wide = area;
    float w[3], n[3];
    for (int c = 0; c < 3; c++)
        w[c] = of[0] * x[i][c] + of[1] * x[j][c] + of[2] * x[k][c];
    const float length = sqrtf(float_dot(w, w)), excess = wide * (length - 1.0f);
    for (int c = 0; c < 3; c++)
        n[c] = w[c] / length;
    for (int p = 0; p < 3; p++)
        for (int c = 0; c < 3; c++)
            f[p][c] -= 40.0f * excess * wide * of[p] * n[c];
}

/* Only the forces of the membrane, in single precision from elements in double precision. */
void float_membrane(int count, const struct element *restrict element, const float (*restrict x)[3],
                    float (*b)[3]) {
    for (int t = 0; t < count; t++) {
        const int i = element[t].vertex[0], j = element[t].vertex[1], k = element[t].vertex[2];
        float f[3][3] = {{0}};
        float_strain(x, i, j, k, element[t].u, element[t].area, f);
        float_strain(x, i, j, k, element[t].v, element[t].area, f);
        for (int c = 0; c < 3; c++) {
            b[i][c] += f[0][c];
            b[j][c] += f[1][c];
            b[k][c] += f[2][c];
        }
    }
}

/* Contact forces between pairs of particles; most pairs do not touch. */
void contacts(int count, const int (*pair)[2], const double (*x)[3], const double (*v)[3],
              const double *radius, double (*force)[3]) {
    for (int t = 0; t < count; t++) {
        const int i = pair[t][0], j = pair[t][1];
        double d[3], u[3];
        for (int c = 0; c < 3; c++) {
            d[c] = x[j][c] - x[i][c];
            u[c] = v[j][c] - v[i][c];
        }
        const double square = dot(d, d), reach = radius[i] + radius[j];
        if (square >= reach * reach)
            continue;
        const double distance = sqrt(square);
        const double approach = dot(d, u) / distance;
        const double push = 900.0 * (reach - distance) * sqrt(reach - distance) - 2.0 * approach;
        if (push <= 0.0)
            continue;
        for (int c = 0; c < 3; c++) {
            force[i][c] -= push * d[c] / distance;
            force[j][c] += push * d[c] / distance;
        }
    }
}

/* Computes the contact force between two balls. Returns 1 if they touch, 0 otherwise. */
static int contact(const double (*x)[3], const double *radius, int i, int j, double force[3]) {
    double d[3];
    for (int c = 0; c < 3; c++)
        d[c] = x[j][c] - x[i][c];
    const double reach = radius[i] + radius[j], square = dot(d, d);
    if (square >= reach * reach)
        return 0;
    const double distance = sqrt(square);
    const double depth = reach - distance;
    double push = 900.0 * depth * sqrt(depth);
    if (push > 50.0)
        push = 50.0;
    for (int c = 0; c < 3; c++)
        force[c] = push * d[c] / distance;
    return 1;
}

/* Contact forces, computed by a function that returns whether there is a contact. */
void touching(int count, const int (*pair)[2], const double (*x)[3], const double *radius,
              double (*force)[3]) {
    for (int t = 0; t < count; t++) {
        const int i = pair[t][0], j = pair[t][1];
        double f[3];
        if (contact(x, radius, i, j, f))
            for (int c = 0; c < 3; c++) {
                force[i][c] -= f[c];
                force[j][c] += f[c];
            }
    }
}

/* Lennard-Jones forces with a cut-off; each pair is listed once. */
void lennard_jones(int count, const int (*pair)[2], const double (*x)[3], double (*force)[3]) {
    for (int t = 0; t < count; t++) {
        const int i = pair[t][0], j = pair[t][1];
        const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
        const double square = dx * dx + dy * dy + dz * dz;
        if (square < 1.7) {
            const double inverse = 1.0 / square, sixth = inverse * inverse * inverse;
            const double f = 48.0 * inverse * sixth * (sixth - 0.5);
            force[i][0] += f * dx;
            force[i][1] += f * dy;
            force[i][2] += f * dz;
            force[j][0] -= f * dx;
            force[j][1] -= f * dy;
            force[j][2] -= f * dz;
        }
    }
}

/* Springs along the edges of the mesh. */
void springs(int count, const int (*edge)[2], const double *rest, const double (*x)[3],
             double (*force)[3]) {
    for (int t = 0; t < count; t++) {
        const int i = edge[t][0], j = edge[t][1];
        double d[3];
        for (int c = 0; c < 3; c++)
            d[c] = x[j][c] - x[i][c];
        const double length = sqrt(dot(d, d));
        const double pull = 80.0 * (length - rest[t]) / length;
        for (int c = 0; c < 3; c++) {
            force[i][c] += pull * d[c];
            force[j][c] -= pull * d[c];
        }
    }
}

/* Returns the index of an entry in a row of a sparse matrix, found by bisection. */
static int place_of(const int *start, const int *column, int row, int wanted) {
    int low = start[row], high = start[row + 1] - 1;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (column[middle] < wanted)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static void cross(const double a[3], const double b[3], double result[3]) {
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

/* Assembles linear elastic tetrahedra into a matrix of blocks in rows. */
void tetrahedra(int count, const int (*corner)[4], const double (*x)[3], const int *start,
                const int *column, double (*k)[3][3]) {
    for (int t = 0; t < count; t++) {
        double edge[3][3], g[4][3], stiffness[4][4][3][3];
        for (int p = 0; p < 3; p++)
            for (int c = 0; c < 3; c++)
                edge[p][c] = x[corner[t][p + 1]][c] - x[corner[t][0]][c];
        cross(edge[1], edge[2], g[1]);
        cross(edge[2], edge[0], g[2]);
        cross(edge[0], edge[1], g[3]);
        const double six = dot(edge[0], g[1]), volume = fabs(six) / 6.0;
        for (int c = 0; c < 3; c++) {
            for (int p = 1; p < 4; p++)
                g[p][c] /= six;
            g[0][c] = -(g[1][c] + g[2][c] + g[3][c]);
        }
        for (int p = 0; p < 4; p++)
            for (int q = 0; q < 4; q++) {
                const double along = dot(g[p], g[q]);
                for (int r = 0; r < 3; r++)
                    for (int c = 0; c < 3; c++)
                        stiffness[p][q][r][c] =
                            volume * (1.2 * g[p][r] * g[q][c] + 0.8 * g[p][c] * g[q][r] +
                                      (r == c ? 0.8 * along : 0.0));
            }
        for (int p = 0; p < 4; p++)
            for (int q = 0; q < 4; q++) {
                const int at = place_of(start, column, corner[t][p], corner[t][q]);
                for (int r = 0; r < 3; r++)
                    for (int c = 0; c < 3; c++)
                        k[at][r][c] += stiffness[p][q][r][c];
            }
    }
}

/* The product with a symmetric matrix that stores its upper half. */
void half_product(int rows, const int *start, const int *column, const double *value,
                  const double *x, double *y) {
    for (int i = 0; i < rows; i++)
        for (int k = start[i]; k < start[i + 1]; k++) {
            const int j = column[k];
            y[i] += value[k] * x[j];
            if (i != j)
                y[j] += value[k] * x[i];
        }
}
