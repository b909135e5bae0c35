/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The loops of bench/lanes: written as a programmer writes them, translated by redcc as they are,
 * and compiled untouched beside that. */
#include <math.h>

#include "lanes_kernels.h"

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* One strain of a triangle, along u or v: |sum of weight[a] x[a]| is to be 1. */
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

/* Contact of particles that may touch: most pairs do not. */
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
