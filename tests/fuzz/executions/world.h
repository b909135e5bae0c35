/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A problem in its own block of memory, and changes that a program may make between two executions
 * of a loop. Two worlds that get the same changes stay equal, byte for byte, as long as the loops
 * have equal results.
 */
#ifndef EXECUTIONS_WORLD_H
#define EXECUTIONS_WORLD_H

#include <stddef.h>
#include <stdint.h>

#include "../random.h"
#include "kernels.h"

typedef struct world {
    problem problem;
    unsigned char *memory; /* the problem's arrays, owned */
    size_t size, taken;
    int most;       /* maximum number of iterations that fit */
    double *own;    /* address of h while it overlaps nothing */
    int *places[2]; /* the two addresses at which the subscripts may lie */
} world;

typedef struct world_shape {
    int most, rows;
    enum {
        SUBSCRIPTS_RANDOM,
        SUBSCRIPTS_SORTED,
        SUBSCRIPTS_NEARLY_SORTED,
        SUBSCRIPTS_CROWDED
    } order;
} world_shape;

typedef enum change {
    CHANGE_NOTHING,
    CHANGE_ONE_SUBSCRIPT,
    CHANGE_ALL_SUBSCRIPTS,
    CHANGE_TWO_EXCHANGED, /* the same subscripts in another order */
    CHANGE_TO_AND_FRO,    /* two orders alternate */
    CHANGE_TABLE,
    CHANGE_VALUES,
    CHANGE_LENGTH,
    CHANGE_PLACE,   /* the subscripts move to other memory */
    CHANGE_OVERLAP, /* updated arrays begin or cease to overlap arrays that are read */
    CHANGE_COUNT
} change;

const char *change_name(change kind);

/** Fills a world, determined by the seed. Returns false if memory is lacking. */
bool world_make(world *w, const world_shape *shape, uint64_t seed);
void world_free(world *w);

/** Changes the world by `kind`, determined by the seed. */
void world_change(world *w, change kind, uint64_t seed);

#endif
