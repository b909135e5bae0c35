/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "binning_data.h"

#include <stdint.h>
#include <stdlib.h>

static unsigned long long random_state = 88172645463325252u;

static uint64_t next_random(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state;
}

static double unit_random(void) {
    return (double)(next_random() >> 11) * 0x1p-53;
}

static double *values;
static float *parts;

static void make_values(void) {
    if (values)
        return;
    values = malloc(TRIP * sizeof *values);
    parts = malloc(TRIP * sizeof *parts);
    for (int t = 0; t < TRIP; t++) {
        values[t] = unit_random() - 0.5;
        parts[t] = (float)values[t];
    }
}

void make_subscripts(struct data *d, enum pattern pattern, size_t rows) {
    int *k = malloc(TRIP * sizeof *k);
    make_values();
    for (redcc_int t = 0; t < TRIP; t++) {
        const uint64_t any = next_random();
        const uint64_t here = (uint64_t)t * rows / TRIP;
        const uint64_t near = here + any % 4096;
        k[t] = (int)(pattern == RANDOM   ? any % rows
                     : pattern == SORTED ? here
                                         : (near < rows ? near : rows - 1));
    }
    *d = (struct data){.trip = TRIP, .rows = rows, .k = k, .value = values, .part = parts};
}

void make_particles(struct data *d, int side) {
    enum { PARTICLES = 2 * MILLION };
    double(*x)[3] = malloc(PARTICLES * sizeof *x);
    for (int p = 0; p < PARTICLES; p++)
        for (int c = 0; c < 3; c++)
            x[p][c] = unit_random() * ((double)side - 1.001);
    *d = (struct data){.trip = PARTICLES,
                       .rows = (size_t)side * (size_t)side * (size_t)side,
                       .x = (const double(*)[3])x,
                       .side = side};
}

void make_neighbours(struct data *d) {
    enum { EDGE = 80, ATOMS = EDGE * EDGE * EDGE };
    int *name = malloc(ATOMS * sizeof *name), *at = malloc(ATOMS * sizeof *at);
    int *start = malloc((ATOMS + 1) * sizeof *start), *k = malloc(13 * ATOMS * sizeof *k);
    double(*x)[3] = malloc(ATOMS * sizeof *x);
    for (int a = 0; a < ATOMS; a++)
        name[a] = a;
    for (int a = ATOMS - 1; a > 0; a--) {
        const int b = (int)(next_random() % (uint64_t)(a + 1)), other = name[a];
        name[a] = name[b];
        name[b] = other;
    }
    for (int a = 0; a < ATOMS; a++)
        at[name[a]] = a;
    start[0] = 0;
    for (int i = 0; i < ATOMS; i++) {
        const int a = at[i], here[3] = {a % EDGE, a / EDGE % EDGE, a / EDGE / EDGE};
        int count = start[i];
        for (int c = 0; c < 3; c++)
            x[i][c] = here[c] + 0.1 * unit_random();
        for (int n = 14; n < 27; n++) {
            const int u = here[0] + n % 3 - 1, v = here[1] + n / 3 % 3 - 1, w = here[2] + n / 9 - 1;
            if (u >= 0 && u < EDGE && v >= 0 && v < EDGE && w < EDGE)
                k[count++] = name[u + EDGE * (v + EDGE * w)];
        }
        start[i + 1] = count;
    }
    free(name);
    free(at);
    *d = (struct data){
        .trip = ATOMS, .rows = ATOMS, .k = k, .start = start, .x = (const double(*)[3])x};
}

void free_data(struct data *d) {
    free((void *)d->k);
    free((void *)d->start);
    free((void *)d->x);
}
