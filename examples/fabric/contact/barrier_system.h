/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The cloth's matrix plus the blocks of contacts; its sparsity pattern changes in every iteration.
 */
#ifndef FABRIC_BARRIER_SYSTEM_H
#define FABRIC_BARRIER_SYSTEM_H

#include "barrier.h"
#include "system/system.h"

typedef struct barrier_system {
    linear_system all; /* rows: the cloth's vertices */
    int (*elastic)[2]; /* [elastic_count] blocks of the cloth's own matrix: row, column */
    int elastic_count;
    int (*couple)[4]; /* [room] vertices of the cloth that an element couples */
    int (*place)[10]; /* [room] index in `all` of each of an element's blocks; -1: not in `all` */
    int couple_room, place_room;
    double (*push)[3]; /* [surface's vertices] N, sum of the elements' gradients */
} barrier_system;

/** A is the cloth's matrix without contact; only its sparsity pattern is used. Returns 0, or -1 if
 *  out of memory. */
int barrier_system_init(barrier_system *s, const block_matrix *A, int surface_vertices);
void barrier_system_free(barrier_system *s);

/** Sets s->all to A + h^2 (sum of the elements' Hessians) and b - h (sum of their gradients), with
 *  A and b of `cloth`. The gradients include the change that b->displacement of bodies causes.
 *  Returns 0, or -1 if out of memory. */
int barrier_system_make(barrier_system *s, barrier *b, double h, const linear_system *cloth);

#endif
