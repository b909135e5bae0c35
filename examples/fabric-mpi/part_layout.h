/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Shared by the files that make a part (part.c) and its exchange (part_exchange.c). */
#ifndef FABRIC_MPI_PART_LAYOUT_H
#define FABRIC_MPI_PART_LAYOUT_H

#include "part.h"

/** Allocates zeroed memory, which the caller frees. Ends the program if out of memory. */
void *part_memory(size_t count, size_t size);

/** The division of the whole cloth into blocks. */
typedef struct division {
    int count;  /* number of blocks */
    int *first; /* [count + 1] each block's first vertex */
    int *of;    /* [vertices] each vertex's block */
    int *owner; /* [count] the rank that owns each block */
} division;

/** Sets d->owner: an equal number of consecutive blocks for each rank or, with the option
 *  -mat_partitioning_type (PETSC_OPTIONS; ptscotch), PETSc's partition of the blocks' graph. Every
 *  rank gets at least one block. Collective. */
void part_share_blocks(const part *p, const mesh *whole, division *d);

/** Fills mesh, global, hinge and block of the rank's part of `whole`. */
void part_take(part *p, const mesh *whole, const division *d);

/** Makes the part's exchanges (all, own, ghosts, kind) and sums. Collective. */
void part_connect(part *p, const division *d);
void part_disconnect(part *p);

/* fabric's own functions, which the linker renames (--wrap). */
simulation *__real_simulation_new(const mesh *m, const scene *s, char *error);
void __real_simulation_free(simulation *sim);

#endif
