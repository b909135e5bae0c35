/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the making of a part (part.c) shares with its exchange (part_exchange.c). */
#ifndef FABRIC_MPI_PART_LAYOUT_H
#define FABRIC_MPI_PART_LAYOUT_H

#include "part.h"

/** Zeroed; ends the program where there is none. To be freed. */
void *part_memory(size_t count, size_t size);

/** Mesh, global, hinge and blocks of the rank's part of `whole`, by the owners of its blocks. */
void part_take(part *p, const mesh *whole, const int *owner);

/** Lays out who sends what to whom. Collective. */
void part_connect(part *p, const int *owner);
void part_disconnect(part *p);

/* fabric's own, which the linker gives another name here (--wrap). */
simulation *__real_simulation_new(const mesh *m, const scene *s, char *error);
void __real_simulation_free(simulation *sim);

#endif
