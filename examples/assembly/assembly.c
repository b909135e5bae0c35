/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Finite elements: assembles the right-hand side of Poisson's equation on a triangulated square,
 * and the lumped masses, triangle by triangle. Prints a checksum of all bits of the result, and on
 * standard error the seconds that it took.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SIDE = 500, NODES = SIDE * SIDE, TRIANGLES = 2 * (SIDE - 1) * (SIDE - 1), RUNS = 40 };

static double load_at(double x, double y) {
    return x * (1 - x) + y * (1 - y);
}

/* The loop that redcc parallelises: up to six triangles update the same node. */
static void assemble(int n, const int (*node)[3], const double (*x)[2], double *mass,
                     double *load) {
    for (int t = 0; t < n; t++) {
        const double *p = x[node[t][0]], *q = x[node[t][1]], *r = x[node[t][2]];
        const double area = 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
        const double f = load_at((p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3);
        for (int k = 0; k < 3; k++) {
            mass[node[t][k]] += area / 3;
            load[node[t][k]] += f * area / 3;
        }
    }
}

static void fill_square(int (*node)[3], double (*x)[2]) {
    for (int i = 0; i < NODES; i++) {
        x[i][0] = (double)(i % SIDE) / (SIDE - 1);
        x[i][1] = (double)(i / SIDE) / (SIDE - 1);
    }
    for (int row = 0, t = 0; row + 1 < SIDE; row++)
        for (int column = 0; column + 1 < SIDE; column++) {
            const int i = row * SIDE + column;
            const int two[2][3] = {{i, i + 1, i + SIDE}, {i + 1, i + SIDE + 1, i + SIDE}};
            memcpy(node[t], two, sizeof two);
            t += 2;
        }
}

static double seconds_now(void) {
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(void) {
    int(*node)[3] = malloc(TRIANGLES * sizeof *node);
    double(*x)[2] = malloc(NODES * sizeof *x);
    double *mass = calloc(NODES, sizeof *mass), *load = calloc(NODES, sizeof *load);
    if (!node || !x || !mass || !load)
        return 1;
    fill_square(node, x);
    const double begin = seconds_now();
    for (int run = 0; run < RUNS; run++)
        assemble(TRIANGLES, (const int(*)[3])node, (const double(*)[2])x, mass, load);
    fprintf(stderr, "%.3f s\n", seconds_now() - begin);
    uint64_t sum = 0, bits[2];
    for (int i = 0; i < NODES; i++) {
        memcpy(&bits[0], &mass[i], sizeof bits[0]);
        memcpy(&bits[1], &load[i], sizeof bits[1]);
        sum = (sum * 31 + bits[0]) * 31 + bits[1];
    }
    printf("assembly %016llx\n", (unsigned long long)sum);
    free(node), free(x), free(mass), free(load);
    return 0;
}
