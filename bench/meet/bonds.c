/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Forces of bonds that have pointers to their two atoms. In the version by hand, each thread owns
 * a share of the atoms, and executes the bonds that have an atom of this share. */
#include "meet.h"

#include <math.h>

enum { SIDE = 64, ATOMS = SIDE * SIDE * 48, BONDS = 3 * ATOMS, MOST_THREADS = 64 };

typedef struct atom {
    double at[3], force[3];
} atom;
typedef struct bond {
    atom *a, *b;
    double length, stiffness;
} bond;

static atom *atoms;
static bond *bonds;

#ifndef BY_HAND
static void pull(int n, const bond *bond) {
    for (int t = 0; t < n; t++) {
        double d[3], rr = 0;
        for (int c = 0; c < 3; c++) {
            d[c] = bond[t].b->at[c] - bond[t].a->at[c];
            rr += d[c] * d[c];
        }
        const double r = sqrt(rr), stretch = (r - bond[t].length) / bond[t].length;
        const double f = bond[t].stiffness * stretch * (1 + 0.5 * stretch * stretch) / r;
        for (int c = 0; c < 3; c++) {
            bond[t].a->force[c] += f * d[c];
            bond[t].b->force[c] -= f * d[c];
        }
    }
}
#else
#include <omp.h>
static void pull(int n, const bond *bond) {
#pragma omp parallel
    {
        const int me = omp_get_thread_num(), all = omp_get_num_threads();
        const atom *low = atoms + (long)ATOMS * me / all,
                   *high = atoms + (long)ATOMS * (me + 1) / all;
        static int first[MOST_THREADS], end[MOST_THREADS]; /* a thread's bonds: [first, end) */
        for (int t = 0; end[me] == 0 && t < n; t++)
            if ((bond[n - 1 - t].a >= low && bond[n - 1 - t].a < high) ||
                (bond[n - 1 - t].b >= low && bond[n - 1 - t].b < high))
                first[me] = n - 1 - t;
        for (int t = n; end[me] == 0; t--)
            if ((bond[t - 1].a >= low && bond[t - 1].a < high) ||
                (bond[t - 1].b >= low && bond[t - 1].b < high))
                end[me] = t;
        for (int t = first[me]; t < end[me]; t++) {
            const int has_a = bond[t].a >= low && bond[t].a < high;
            const int has_b = bond[t].b >= low && bond[t].b < high;
            if (!has_a && !has_b)
                continue;
            double d[3], rr = 0;
            for (int c = 0; c < 3; c++) {
                d[c] = bond[t].b->at[c] - bond[t].a->at[c];
                rr += d[c] * d[c];
            }
            const double r = sqrt(rr), stretch = (r - bond[t].length) / bond[t].length;
            const double f = bond[t].stiffness * stretch * (1 + 0.5 * stretch * stretch) / r;
            for (int c = 0; has_a && c < 3; c++)
                bond[t].a->force[c] += f * d[c];
            for (int c = 0; has_b && c < 3; c++)
                bond[t].b->force[c] -= f * d[c];
        }
    }
}
#endif

void make(void) {
    atoms = room(ATOMS * sizeof *atoms);
    bonds = room(BONDS * sizeof *bonds);
    for (int a = 0; a < ATOMS; a++)
        for (int k = 0; k < 3; k++) {
            const int step = k == 0 ? 1 : k == 1 ? SIDE : SIDE * SIDE;
            bonds[3 * a + k] = (bond){&atoms[a], &atoms[a + step < ATOMS ? a + step : a - step],
                                      0.5 + draw(), 1 + draw()};
        }
    change();
}

void change(void) {
    for (int a = 0; a < ATOMS; a++) {
        atoms[a].at[0] = a / (SIDE * SIDE) + 0.5 * draw();
        atoms[a].at[1] = a / SIDE % SIDE + 0.5 * draw();
        atoms[a].at[2] = a % SIDE + 0.5 * draw();
    }
}

void call(void) {
    pull(BONDS, bonds);
}

const void *results(size_t *size) {
    *size = ATOMS * sizeof *atoms;
    return atoms;
}
