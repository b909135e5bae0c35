/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Forces between all pairs of charges, with coordinates in a flat array, and the sum of the
 * energies. In the version by hand, tiles of pairs are executed one anti-diagonal after another.
 * Energies are stored first, and then added up in the order of the sequential loop. */
#include "meet.h"

#include <math.h>

#ifndef POINTS
enum { POINTS = 1000 };
#endif

static double *at, *force, *energy; /* energy points to the element after the forces */

#ifndef BY_HAND
static void repel(int n, const double *r, double *f, double *sum) {
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++) {
            double d[3], rr = 0.01;
            for (int k = 0; k < 3; k++) {
                d[k] = r[3 * i + k] - r[3 * j + k];
                rr += d[k] * d[k];
            }
            const double e = 1 / sqrt(rr);
            *sum += e;
            for (int k = 0; k < 3; k++) {
                f[3 * i + k] += e / rr * d[k];
                f[3 * j + k] -= e / rr * d[k];
            }
        }
}
#else
static double energies[POINTS][POINTS];

static void repel_tile(int n, int side, int band, int block, const double *r, double *f) {
    const int to = (band + 1) * side < n ? (band + 1) * side : n;
    const int last = (block + 1) * side < n ? (block + 1) * side : n;
    for (int i = band * side; i < to; i++)
        for (int j = block > band ? block * side : i + 1; j < last; j++) {
            double d[3], rr = 0.01;
            for (int k = 0; k < 3; k++) {
                d[k] = r[3 * i + k] - r[3 * j + k];
                rr += d[k] * d[k];
            }
            const double e = 1 / sqrt(rr);
            energies[i][j] = e;
            for (int k = 0; k < 3; k++) {
                f[3 * i + k] += e / rr * d[k];
                f[3 * j + k] -= e / rr * d[k];
            }
        }
}

static void repel(int n, const double *r, double *f, double *sum) {
    const int side = 50, blocks = (n + side - 1) / side;
#pragma omp parallel
    for (int diagonal = 0; diagonal < 2 * blocks - 1; diagonal++) {
        const int first = diagonal < blocks ? 0 : diagonal - blocks + 1;
#pragma omp for schedule(dynamic, 1)
        for (int band = first; band <= diagonal / 2; band++)
            repel_tile(n, side, band, diagonal - band, r, f);
    }
    double all = *sum;
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++)
            all += energies[i][j];
    *sum = all;
}
#endif

void make(void) {
    at = room(3 * POINTS * sizeof *at);
    force = room((3 * POINTS + 1) * sizeof *force);
    energy = force + 3 * POINTS;
    change();
}

void change(void) {
    for (int i = 0; i < 3 * POINTS; i++)
        at[i] = draw();
}

void call(void) {
    repel(POINTS, at, force, energy);
}

const void *results(size_t *size) {
    *size = (3 * POINTS + 1) * sizeof *force;
    return force;
}
