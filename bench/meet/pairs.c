/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** All pairs of points attract each other; the inner loop keeps the sum of a point's forces in
 * local variables. In the version by hand, tiles of pairs are executed one anti-diagonal after
 * another. */
#include "meet.h"

#include <math.h>

#ifndef POINTS
enum { POINTS = 4000 };
#endif

static double *x, *y, *z, *mass, *force; /* force: all x components, then all y, then all z */

#ifndef BY_HAND
static void attract(int n, double *fx, double *fy, double *fz) {
    for (int i = 0; i < n; i++) {
        double sx = 0, sy = 0, sz = 0;
        for (int j = i + 1; j < n; j++) {
            const double dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i];
            const double rr = dx * dx + dy * dy + dz * dz + 0.01;
            const double pull = mass[i] * mass[j] / (rr * sqrt(rr));
            sx += pull * dx;
            sy += pull * dy;
            sz += pull * dz;
            fx[j] -= pull * dx;
            fy[j] -= pull * dy;
            fz[j] -= pull * dz;
        }
        fx[i] += sx;
        fy[i] += sy;
        fz[i] += sz;
    }
}
#else
static double sums[POINTS][3];

static void attract_tile(int n, int side, int band, int block, double *fx, double *fy, double *fz) {
    const int to = (band + 1) * side < n ? (band + 1) * side : n;
    const int last = (block + 1) * side < n ? (block + 1) * side : n;
    for (int i = band * side; i < to; i++) {
        double sx = 0, sy = 0, sz = 0;
        if (block > band)
            sx = sums[i][0], sy = sums[i][1], sz = sums[i][2];
        for (int j = block > band ? block * side : i + 1; j < last; j++) {
            const double dx = x[j] - x[i], dy = y[j] - y[i], dz = z[j] - z[i];
            const double rr = dx * dx + dy * dy + dz * dz + 0.01;
            const double pull = mass[i] * mass[j] / (rr * sqrt(rr));
            sx += pull * dx;
            sy += pull * dy;
            sz += pull * dz;
            fx[j] -= pull * dx;
            fy[j] -= pull * dy;
            fz[j] -= pull * dz;
        }
        sums[i][0] = sx, sums[i][1] = sy, sums[i][2] = sz;
        if (last == n) {
            fx[i] += sx;
            fy[i] += sy;
            fz[i] += sz;
        }
    }
}

static void attract(int n, double *fx, double *fy, double *fz) {
    const int side = n > 2000 ? 125 : 50, blocks = (n + side - 1) / side;
#pragma omp parallel
    for (int diagonal = 0; diagonal < 2 * blocks - 1; diagonal++) {
        const int first = diagonal < blocks ? 0 : diagonal - blocks + 1;
#pragma omp for schedule(dynamic, 1)
        for (int band = first; band <= diagonal / 2; band++)
            attract_tile(n, side, band, diagonal - band, fx, fy, fz);
    }
}
#endif

void make(void) {
    x = room(POINTS * sizeof *x);
    y = room(POINTS * sizeof *y);
    z = room(POINTS * sizeof *z);
    mass = room(POINTS * sizeof *mass);
    force = room(3 * POINTS * sizeof *force);
    for (int i = 0; i < POINTS; i++)
        mass[i] = 1 + draw();
    change();
}

void change(void) {
    for (int i = 0; i < POINTS; i++)
        x[i] = draw(), y[i] = draw(), z[i] = draw();
}

void call(void) {
    attract(POINTS, force, force + POINTS, force + 2 * POINTS);
}

const void *results(size_t *size) {
    *size = 3 * POINTS * sizeof *force;
    return force;
}
