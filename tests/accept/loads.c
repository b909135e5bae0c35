/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Arrays behind pointers in records that a loop reads only under conditions. If no condition holds, the
// record may not exist. Also: inner sums together with blocks that a thread may skip.
// INTEGERS: no
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include "case.h"

enum { N = 700, ROOM = 8, NEAR = 9 };
struct atoms { double (*r)[3]; double *u; double (*f)[3]; int *id; };
struct boxes { int count, *atoms; struct { int *near; } list; };
struct all { long unused; struct boxes *boxes; struct atoms *atoms; };

static double r[N * ROOM][3], u[N * ROOM], f[N * ROOM][3];
static int id[N * ROOM], atoms[N], near_boxes[NEAR * N];

/* Pairs of blocks, a list private to the iteration, conditions, and an energy summed in the order of the loop. */
__attribute__((noipa)) static double forces(struct all *s, double cut, double weight) {
    double energy = 0.25;
    int list[NEAR];
    for (int i = 0; i < s->boxes->count; i++) { // EXPECT: transformed
        const int own = s->boxes->atoms[i];
        if (own == 0)
            continue;
        for (int q = 0; q < NEAR; q++)
            list[q] = s->boxes->list.near[NEAR * i + q];
        for (int q = 0; q < NEAR; q++) {
            const int j = list[q], other = s->boxes->atoms[j];
            if (j < 0)
                return -1;
            for (int a = ROOM * i, k = 0; k < own; k++, a++)
                for (int b = ROOM * j, l = 0; l < other; l++, b++) {
                    double d[3], r2 = 0;
                    if (s->atoms->id[b] <= s->atoms->id[a])
                        continue;
                    for (int m = 0; m < 3; m++) {
                        d[m] = s->atoms->r[a][m] - s->atoms->r[b][m];
                        r2 += d[m] * d[m];
                    }
                    if (r2 > cut)
                        continue;
                    const double e = weight / (0.1 + r2);
                    s->atoms->u[a] += 0.5 * e;
                    s->atoms->u[b] += 0.5 * e;
                    if (j % 3)
                        energy += e;
                    else
                        energy += 0.5 * e;
                    for (int m = 0; m < 3; m++) {
                        s->atoms->f[a][m] -= d[m] * e;
                        s->atoms->f[b][m] += d[m] * e;
                    }
                }
        }
    }
    return energy;
}

struct target { int n; double *h; };
__attribute__((noipa)) static int sums(struct target *t, const int *k, int n, int from) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        if (k[i] < from)
            continue;
        t->h[k[i]] += r[k[i]][0];
    }
    return n;
}

/* The record is a null pointer, or lies on a page that cannot be read. */
static void never(const int *k) {
    void *const page = mmap(NULL, 4096, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    for (int round = 0; round < 4; round++) {
        sums(NULL, k, N, 1 << 20);
        sums(page, k, N, 1 << 20);
        usleep(100);
    }
    munmap(page, 4096);
}

int main(void) {
    case_values(&r[0][0], 3 * N * ROOM);
    case_subscripts(near_boxes, NEAR * N, N);
    case_subscripts(id, N * ROOM, 1000);
    case_subscripts(atoms, N, ROOM + 1);
    for (int i = 0; i < N; i++)
        for (int q = 0; q < NEAR - 2; q++)
            near_boxes[NEAR * i + q] = (i + q) % N;
    struct boxes boxes = {N, atoms, {near_boxes}};
    struct atoms all_atoms = {r, u, f, id};
    struct all all = {0, &boxes, &all_atoms};
    struct target target = {N, u};
    double energies[8] = {0};
    never(id);
    for (int round = 0; round < 4; round++) {
        energies[round] = forces(&all, 0.4, 1e-3);
        all.atoms = NULL; /* not read, since count is small and atoms are 0 */
        boxes.count = round;
        atoms[0] = atoms[1] = atoms[2] = 0;
        energies[4 + round] = forces(&all, 0.4, 1e-3);
        all.atoms = &all_atoms;
        boxes.count = N;
        atoms[0] = round + 1;
        sums(&target, id, N * ROOM, 3);
    }
    near_boxes[NEAR * (N / 2) + 4] = 5;
    energies[7] = forces(&all, 1e9, 1e-3);
    CASE_PRINT(energies);
    CASE_PRINT(u);
    CASE_PRINT(f);
    return 0;
}
