/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the loops of bench/binning.c read. One thread; what is made is given to free_data. */
#ifndef BENCH_BINNING_DATA_H
#define BENCH_BINNING_DATA_H

#include "redcc/runtime.h"

#include <stddef.h>

enum { TRIP = 10000000, MILLION = 1 << 20 };

/** What a loop reads, new in each of the sets. */
struct data {
    redcc_int trip;
    size_t rows;
    const int *k;     /* subscripts, or neighbours */
    const int *start; /* [trip + 1] of the neighbours */
    const double *value;
    const float *part;
    const double (*x)[3];
    int side; /* of the particles' grid, in cells */
};

/** Where subscripts go. */
enum pattern { RANDOM, SORTED, BANDED };

/** TRIP subscripts of so many rows, and values, which all data share. */
void make_subscripts(struct data *d, enum pattern pattern, size_t rows);

/** Particles anywhere in a grid of side * side * side cells. */
void make_particles(struct data *d, int side);

/** Atoms on a lattice, each with half of its 26 neighbours, numbered at random. */
void make_neighbours(struct data *d);

/** Gives back what is not shared. */
void free_data(struct data *d);

#endif
