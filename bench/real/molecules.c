/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Molecular dynamics of a Lennard-Jones liquid, in reduced units.
 *
 *   molecules CELLS STEPS >trajectory
 *
 * A periodic cube of 4 CELLS^3 atoms starts as a face-centred lattice with small random velocities.
 * The velocity Verlet method integrates the motion. Forces are computed from a neighbour list,
 * which is rebuilt by linked cells every twentieth step. Each pair is listed once, and its force is
 * added to both atoms. Every twentieth step prints the energies. At the end the program prints
 * positions.
 *
 * The method and the form of its loops are those of M. P. Allen and D. J. Tildesley, Computer
 * Simulation of Liquids, Oxford 1987, programs F.4, F.17, F.19 and F.20. The list is due to L.
 * Verlet, Phys. Rev. 159 (1967) 98.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define DENSITY 0.8442
#define CUTOFF 2.5
#define SKIN 0.3
#define DT 0.004
#define REBUILD 20         /* number of steps between rebuilds of the neighbour list */
#define MOST_NEIGHBOURS 60 /* capacity of the list, as a number of neighbours per atom */

static int natoms;
static double box;
static double (*r)[3], (*v)[3], (*f)[3];
static int *point, *list; /* atom i's neighbours are list[point[i]] to list[point[i + 1] - 1] */

static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory) {
        fprintf(stderr, "molecules: out of memory\n");
        exit(1);
    }
    return memory;
}

/* Returns a random number, uniform in (-1/2, 1/2), by Park and Miller's minimal standard
 * generator. */
static double uniform(void) {
    static long seed = 20011;
    seed = seed * 16807 % 2147483647;
    return (double)seed / 2147483647.0 - 0.5;
}

static void lattice(int cells) {
    static const double site[4][3] = {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
    const double a = box / cells;
    int i = 0;
    for (int x = 0; x < cells; x++)
        for (int y = 0; y < cells; y++)
            for (int z = 0; z < cells; z++)
                for (int s = 0; s < 4; s++, i++) {
                    r[i][0] = a * (x + site[s][0]);
                    r[i][1] = a * (y + site[s][1]);
                    r[i][2] = a * (z + site[s][2]);
                    for (int c = 0; c < 3; c++)
                        v[i][c] = 4.0 * uniform();
                }
}

/* Returns d, the difference of a coordinate of two atoms, for their nearest periodic images. */
static double image(double d) {
    if (d > 0.5 * box)
        return d - box;
    if (d < -0.5 * box)
        return d + box;
    return d;
}

static double distance2(const double *a, const double *b) {
    const double dx = image(a[0] - b[0]), dy = image(a[1] - b[1]), dz = image(a[2] - b[2]);
    return dx * dx + dy * dy + dz * dz;
}

static int cell_of(double x, int ncell) {
    const int c = (int)floor(x / box * ncell);
    return c < 0 ? 0 : c >= ncell ? ncell - 1 : c;
}

/* Appends to the neighbour list, which has n entries, those of the atoms j, next[j], ... that are
 * within the list's radius of atom i. Returns the new number of entries. */
static int scan(const int *next, int j, int i, int n) {
    const double reach = (CUTOFF + SKIN) * (CUTOFF + SKIN);
    for (; j >= 0; j = next[j])
        if (distance2(r[i], r[j]) < reach)
            list[n++] = j;
    return n;
}

/* Builds the neighbour list by linked cells, whose sides are at least as long as the list's radius.
 * It searches half of a cell's 26 neighbours, so that each pair is found once. */
static void neighbours(void) {
    const int m = (int)(box / (CUTOFF + SKIN));
    int *head = allocate((size_t)m * m * m, sizeof *head), *next = allocate(natoms, sizeof *next);
    for (int c = 0; c < m * m * m; c++)
        head[c] = -1;
    for (int i = natoms - 1; i >= 0; i--) {
        const int c = (cell_of(r[i][0], m) * m + cell_of(r[i][1], m)) * m + cell_of(r[i][2], m);
        next[i] = head[c];
        head[c] = i;
    }
    int n = 0;
    for (int i = 0; i < natoms; i++) {
        const int x = cell_of(r[i][0], m), y = cell_of(r[i][1], m), z = cell_of(r[i][2], m);
        point[i] = n;
        n = scan(next, next[i], i, n);
        for (int step = 14; step < 27; step++) {
            const int cx = (x + step / 9 + m - 1) % m, cy = (y + step / 3 % 3 + m - 1) % m;
            n = scan(next, head[(cx * m + cy) * m + (z + step % 3 + m - 1) % m], i, n);
        }
    }
    point[natoms] = n;
    free(head);
    free(next);
}

static void forces(void) {
    const double cut2 = CUTOFF * CUTOFF;
    int i, j, k;
    for (i = 0; i < natoms; i++)
        f[i][0] = f[i][1] = f[i][2] = 0.0;
    for (i = 0; i < natoms; i++) {
        for (k = point[i]; k < point[i + 1]; k++) {
            j = list[k];
            const double dx = image(r[i][0] - r[j][0]);
            const double dy = image(r[i][1] - r[j][1]);
            const double dz = image(r[i][2] - r[j][2]);
            const double r2 = dx * dx + dy * dy + dz * dz;
            if (r2 < cut2) {
                const double ir2 = 1.0 / r2, ir6 = ir2 * ir2 * ir2;
                const double fr = 48.0 * ir2 * ir6 * (ir6 - 0.5);
                f[i][0] += fr * dx;
                f[i][1] += fr * dy;
                f[i][2] += fr * dz;
                f[j][0] -= fr * dx;
                f[j][1] -= fr * dy;
                f[j][2] -= fr * dz;
            }
        }
    }
}

static void report(int step) {
    double kinetic = 0, potential = 0;
    for (int i = 0; i < natoms; i++) {
        kinetic += 0.5 * (v[i][0] * v[i][0] + v[i][1] * v[i][1] + v[i][2] * v[i][2]);
        for (int k = point[i]; k < point[i + 1]; k++) {
            const double r2 = distance2(r[i], r[list[k]]);
            if (r2 < CUTOFF * CUTOFF) {
                const double ir6 = 1.0 / (r2 * r2 * r2);
                potential += 4.0 * ir6 * (ir6 - 1.0);
            }
        }
    }
    printf("%6d %.17g %.17g\n", step, kinetic / natoms, potential / natoms);
}

/* Advances the velocities by half a step and, with `move`, the positions by a whole one. */
static void advance(int move) {
    for (int i = 0; i < natoms; i++)
        for (int c = 0; c < 3; c++) {
            v[i][c] += 0.5 * DT * f[i][c];
            if (move) {
                r[i][c] += DT * v[i][c];
                r[i][c] -= box * floor(r[i][c] / box);
            }
        }
}

int main(int argc, char **argv) {
    if (argc != 3 || atoi(argv[1]) < 6 || atoi(argv[2]) < 1) {
        fprintf(stderr, "usage: molecules CELLS (6 or more) STEPS\n");
        return 2;
    }
    const int cells = atoi(argv[1]), steps = atoi(argv[2]);
    natoms = 4 * cells * cells * cells;
    box = cbrt(natoms / DENSITY);
    r = allocate(natoms, sizeof *r);
    v = allocate(natoms, sizeof *v);
    f = allocate(natoms, sizeof *f);
    point = allocate(natoms + 1, sizeof *point);
    list = allocate((size_t)natoms * MOST_NEIGHBOURS, sizeof *list);
    lattice(cells);
    neighbours();
    forces();
    for (int step = 1; step <= steps; step++) {
        advance(1);
        if (step % REBUILD == 0)
            neighbours();
        forces();
        advance(0);
        if (step % REBUILD == 0)
            report(step);
    }
    for (int i = 0; i < natoms; i++)
        printf("%.17g %.17g %.17g\n", r[i][0], r[i][1], r[i][2]);
    return 0;
}
