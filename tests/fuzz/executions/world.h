/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A problem in a block of memory of its own, and what programs do to theirs between two executions
 * of a loop. Two worlds to which the same is done are equal, byte for byte, as long as the loops
 * are.
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
    int most;       /* iterations that there is room for */
    double *own;    /* where h lies when it overlaps nothing */
    int *places[2]; /* where the subscripts may lie */
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
    CHANGE_TO_AND_FRO,    /* two orders in turn */
    CHANGE_TABLE,
    CHANGE_VALUES,
    CHANGE_LENGTH,
    CHANGE_PLACE,   /* the subscripts move to other memory */
    CHANGE_OVERLAP, /* what is updated begins or ceases to overlap what is read */
    CHANGE_COUNT
} change;

const char *change_name(change kind);

/** Fills a world; false: there is no memory. Seeds determine it. */
bool world_make(world *w, const world_shape *shape, uint64_t seed);
void world_free(world *w);

/** Does to the world what `kind` says; seeds determine it. */
void world_change(world *w, change kind, uint64_t seed);

#endif
