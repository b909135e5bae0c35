/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Forces and energy of a Lennard-Jones liquid, from neighbour lists in which each pair occurs
 * once. In the version by hand, each thread owns a share of the atoms, and skips the lists that
 * begin after its share or end before it. Energies are stored first, and then added up in the order
 * of the sequential loop. */
#include "meet.h"

#include <math.h>

enum { SIDE = 56, ATOMS = SIDE * SIDE * SIDE / 4, MOST = 40 };

static int *start, *list, *last; /* last: each atom's greatest neighbour, for the loop by hand */
static double (*at)[3], (*force)[3], *energy; /* energy points to the element after the forces */

#ifndef BY_HAND
static void interact(int n, const double (*r)[3], double (*f)[3], double cut) {
    double sum = 0;
    for (int i = 0; i < n; i++)
        for (int k = start[i]; k < start[i + 1]; k++) {
            const int j = list[k];
            const double dx = r[i][0] - r[j][0], dy = r[i][1] - r[j][1], dz = r[i][2] - r[j][2];
            const double rr = dx * dx + dy * dy + dz * dz;
            if (rr >= cut)
                continue;
            const double s = 1 / rr, s6 = s * s * s, pull = 48 * s6 * (s6 - 0.5) * s;
            sum += 4 * s6 * (s6 - 1);
            f[i][0] += pull * dx;
            f[i][1] += pull * dy;
            f[i][2] += pull * dz;
            f[j][0] -= pull * dx;
            f[j][1] -= pull * dy;
            f[j][2] -= pull * dz;
        }
    *energy += sum;
}
#else
#include <omp.h>
static double *energies;

static void interact(int n, const double (*r)[3], double (*f)[3], double cut) {
    double sum = 0;
#pragma omp parallel
    {
        const int me = omp_get_thread_num(), all = omp_get_num_threads();
        const int first = (int)((long)n * me / all), end = (int)((long)n * (me + 1) / all);
        for (int i = 0; i < end; i++) {
            const int own = i >= first;
            for (int k = start[i]; k < start[i + 1] && last[i] >= first; k++) {
                const int j = list[k], own_j = j >= first && j < end;
                if (!own && !own_j)
                    continue;
                const double dx = r[i][0] - r[j][0], dy = r[i][1] - r[j][1], dz = r[i][2] - r[j][2];
                const double rr = dx * dx + dy * dy + dz * dz;
                if (own)
                    energies[k] = -0.0;
                if (rr >= cut)
                    continue;
                const double s = 1 / rr, s6 = s * s * s, pull = 48 * s6 * (s6 - 0.5) * s;
                if (own) {
                    energies[k] = 4 * s6 * (s6 - 1);
                    f[i][0] += pull * dx;
                    f[i][1] += pull * dy;
                    f[i][2] += pull * dz;
                }
                if (own_j) {
                    f[j][0] -= pull * dx;
                    f[j][1] -= pull * dy;
                    f[j][2] -= pull * dz;
                }
            }
        }
    }
    for (int k = 0; k < start[n]; k++)
        sum += energies[k];
    *energy += sum;
}
#endif

static void find_neighbours(double reach) {
    int count = 0;
    for (int i = 0; i < ATOMS; i++) {
        start[i] = count;
        last[i] = i;
        /* atoms whose numbers differ by `layer` (three layers) or more are not neighbours */
        const int layer = 3 * SIDE * SIDE;
        for (int j = i + 1; j < ATOMS && j < i + layer; j++) {
            const double dx = at[i][0] - at[j][0], dy = at[i][1] - at[j][1],
                         dz = at[i][2] - at[j][2];
            if (dx * dx + dy * dy + dz * dz < reach && count - start[i] < MOST)
                last[i] = list[count++] = j;
        }
    }
    start[ATOMS] = count;
}

void make(void) {
    start = room((ATOMS + 1) * sizeof *start);
    list = room(ATOMS * MOST * sizeof *list);
    last = room(ATOMS * sizeof *last);
    at = room(ATOMS * sizeof *at);
    force = room((ATOMS + 1) * sizeof *force);
    energy = force[ATOMS];
#ifdef BY_HAND
    energies = room(ATOMS * MOST * sizeof *energies);
#endif
    change();
    find_neighbours(6);
}

void change(void) {
    for (int i = 0; i < ATOMS; i++) {
        at[i][0] = i / (SIDE * SIDE) + 0.2 * draw();
        at[i][1] = i / SIDE % SIDE + 0.2 * draw();
        at[i][2] = i % SIDE + 0.2 * draw();
    }
}

void call(void) {
    interact(ATOMS, (const double(*)[3])at, force, 5);
}

const void *results(size_t *size) {
    *size = (ATOMS + 1) * sizeof *force;
    return force;
}
