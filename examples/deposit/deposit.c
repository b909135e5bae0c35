/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Particle in cell: each particle's charge is distributed over the four corners of its cell in a
 * 512 x 512 grid, with bilinear weights. The particles move a little between deposits. Prints a
 * checksum of all bits of the grid, and on standard error the seconds that it took.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SIDE = 512, CELLS = SIDE * SIDE, PARTICLES = 1000000, STEPS = 10 };

/* The loop that redcc parallelises: any two particles may share a corner. */
static void deposit(int n, const float *x, const float *y, double charge, double *grid) {
    for (int t = 0; t < n; t++) {
        const int i = (int)x[t], j = (int)y[t];
        const double u = (double)x[t] - i, v = (double)y[t] - j;
        double *corner = grid + j * SIDE + i;
        corner[0] += charge * (1 - u) * (1 - v);
        corner[1] += charge * u * (1 - v);
        corner[SIDE] += charge * (1 - u) * v;
        corner[SIDE + 1] += charge * u * v;
    }
}

static float next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u; /* Numerical Recipes' generator */
    return (float)(*state >> 8) / 16777216.0f;
}

/* Moves each particle a little towards lower x and y. One that has reached the border (x or y at
 * most 1) re-enters at the opposite one. */
static void move(int n, float *x, float *y) {
    for (int t = 0; t < n; t++) {
        x[t] = x[t] > 1 ? x[t] - 0.125f : SIDE - 2;
        y[t] = y[t] > 1 ? y[t] - 0.0625f : SIDE - 2;
    }
}

static double seconds_now(void) {
    struct timespec now;
    timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

int main(void) {
    float *x = malloc(PARTICLES * sizeof *x), *y = malloc(PARTICLES * sizeof *y);
    double *grid = calloc(CELLS, sizeof *grid);
    if (!x || !y || !grid)
        return 1;
    uint32_t state = 1;
    for (int t = 0; t < PARTICLES; t++) {
        x[t] = 1 + (SIDE - 3) * next_random(&state);
        y[t] = 1 + (SIDE - 3) * next_random(&state);
    }
    const double begin = seconds_now();
    for (int step = 0; step < STEPS; step++) {
        deposit(PARTICLES, x, y, 1.0 / (double)PARTICLES, grid);
        move(PARTICLES, x, y);
    }
    fprintf(stderr, "%.3f s\n", seconds_now() - begin);
    uint64_t sum = 0, bits;
    for (int i = 0; i < CELLS; i++) {
        memcpy(&bits, &grid[i], sizeof bits);
        sum = sum * 31 + bits;
    }
    printf("deposit %016llx\n", (unsigned long long)sum);
    free(x), free(y), free(grid);
    return 0;
}
