/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the making of a part (part.c) shares with its exchange (part_exchange.c). */
#ifndef FABRIC_MPI_PART_LAYOUT_H
#define FABRIC_MPI_PART_LAYOUT_H

#include "part.h"

/** Zeroed; ends the program where there is none. To be freed. */
void *part_memory(size_t count, size_t size);

/** How the whole cloth is divided. */
typedef struct division {
    int count;  /* blocks */
    int *first; /* [count + 1] a block's first vertex */
    int *of;    /* [vertices] a vertex' block */
    int *owner; /* [count] the rank that owns a block */
} division;

/** d->owner: as many consecutive blocks for each rank, or, with the option -mat_partitioning_type
 *  (PETSC_OPTIONS; ptscotch), as PETSc divides the blocks' graph. Every rank has one block at
 *  least. Collective. */
void part_share_blocks(const part *p, const mesh *whole, division *d);

/** Mesh, global, hinge and blocks of the rank's part of `whole`. */
void part_take(part *p, const mesh *whole, const division *d);

/** Lays out who sends what to whom. Collective. */
void part_connect(part *p, const division *d);
void part_disconnect(part *p);

/* fabric's own, which the linker gives another name here (--wrap). */
simulation *__real_simulation_new(const mesh *m, const scene *s, char *error);
void __real_simulation_free(simulation *sim);

#endif
