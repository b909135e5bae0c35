/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Input data of the loops of bench/binning.c. Not thread-safe. */
#ifndef BENCH_BINNING_DATA_H
#define BENCH_BINNING_DATA_H

#include "redcc/runtime.h"

#include <stddef.h>

enum { TRIP = 10000000, MILLION = 1 << 20 };

/** The data that a loop reads. A benchmark has several sets of data, all different. */
struct data {
    redcc_int trip;
    size_t rows;
    const int *k;     /* subscripts, or neighbours */
    const int *start; /* [trip + 1] index in k of each atom's first neighbour */
    const double *value;
    const float *part;
    const double (*x)[3];
    int side; /* side of the particles' grid, in cells */
};

/** Distributions of subscripts. */
enum pattern { RANDOM, SORTED, BANDED };

/** Makes TRIP subscripts below `rows`, and values. All sets share the values. */
void make_subscripts(struct data *d, enum pattern pattern, size_t rows);

/** Makes particles at random positions in a grid of side * side * side cells. */
void make_particles(struct data *d, int side);

/** Makes atoms on a lattice, numbered at random, each with half of its 26 neighbours in a list. */
void make_neighbours(struct data *d);

/** Frees the data that sets do not share. */
void free_data(struct data *d);

#endif
