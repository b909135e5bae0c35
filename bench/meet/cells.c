/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Forces between atoms of neighbouring cells. In the version by hand, each thread owns a share of
 * the cells, and skips pairs of cells of which it owns neither. */
#include "meet.h"

enum { SIDE = 20, CELLS = SIDE * SIDE * SIDE, ROOM = 24, NEAR = 14 };

static int *count, (*near)[NEAR];
static double (*at)[3], (*force)[3];

#ifdef BY_HAND
#include <omp.h>
#endif

#ifndef BY_HAND
static void meet_in_cells(const double (*r)[3], double (*f)[3], double cut) {
    for (int cell = 0; cell < CELLS; cell++)
        for (int k = 0; k < NEAR; k++) {
            const int other = near[cell][k];
            for (int i = ROOM * cell, p = 0; p < count[cell]; p++, i++)
                for (int j = ROOM * other, q = 0; q < count[other]; q++, j++) {
                    if (cell == other && j <= i)
                        continue;
                    double d[3], rr = 0;
                    for (int c = 0; c < 3; c++) {
                        d[c] = r[i][c] - r[j][c];
                        rr += d[c] * d[c];
                    }
                    if (rr > cut)
                        continue;
                    const double s = 1 / rr, s6 = s * s * s, pull = s6 * (s6 - 0.5) * s;
                    for (int c = 0; c < 3; c++) {
                        f[i][c] += pull * d[c];
                        f[j][c] -= pull * d[c];
                    }
                }
        }
}
#else
static void meet_in_cells(const double (*r)[3], double (*f)[3], double cut) {
#pragma omp parallel
    for (int cell = 0; cell < CELLS; cell++)
        for (int k = 0; k < NEAR; k++) {
            const int other = near[cell][k], me = omp_get_thread_num();
            const int first = cell * omp_get_num_threads() / CELLS == me;
            const int second = other * omp_get_num_threads() / CELLS == me;
            for (int i = ROOM * cell, p = 0; p < count[cell] && (first || second); p++, i++)
                for (int j = ROOM * other, q = 0; q < count[other]; q++, j++) {
                    if (cell == other && j <= i)
                        continue;
                    double d[3], rr = 0;
                    for (int c = 0; c < 3; c++) {
                        d[c] = r[i][c] - r[j][c];
                        rr += d[c] * d[c];
                    }
                    if (rr > cut)
                        continue;
                    const double s = 1 / rr, s6 = s * s * s, pull = s6 * (s6 - 0.5) * s;
                    for (int c = 0; first && c < 3; c++)
                        f[i][c] += pull * d[c];
                    for (int c = 0; second && c < 3; c++)
                        f[j][c] -= pull * d[c];
                }
        }
}
#endif

static int cell_at(int x, int y, int z) {
    return ((x + SIDE) % SIDE * SIDE + (y + SIDE) % SIDE) * SIDE + (z + SIDE) % SIDE;
}

/* Lists in near[cell] the cell itself and half of its 26 neighbours. */
static void find_near(int cell) {
    const int x = cell / SIDE / SIDE, y = cell / SIDE % SIDE, z = cell % SIDE;
    for (int k = 0; k < NEAR; k++) {
        const int d = k + 13;
        near[cell][k] = cell_at(x + d / 9 - 1, y + d / 3 % 3 - 1, z + d % 3 - 1);
    }
}

void make(void) {
    count = room(CELLS * sizeof *count);
    near = room(CELLS * sizeof *near);
    at = room(ROOM * CELLS * sizeof *at);
    force = room(ROOM * CELLS * sizeof *force);
    for (int cell = 0; cell < CELLS; cell++)
        find_near(cell);
    change();
}

/* Puts a new random number of atoms into each cell, at new random positions. */
void change(void) {
    for (int cell = 0; cell < CELLS; cell++) {
        count[cell] = 4 + (int)(5 * draw());
        for (int i = ROOM * cell; i < ROOM * cell + count[cell]; i++) {
            at[i][0] = cell / SIDE / SIDE + draw();
            at[i][1] = cell / SIDE % SIDE + draw();
            at[i][2] = cell % SIDE + draw();
        }
    }
}

void call(void) {
    meet_in_cells((const double(*)[3])at, force, 1);
}

const void *results(size_t *size) {
    *size = ROOM * CELLS * sizeof *force;
    return force;
}
