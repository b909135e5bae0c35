/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Whether a mesh is the surface of a solid, as far as a collider needs it to be (surface.h). */
#ifndef FABRIC_SURFACE_CHECK_H
#define FABRIC_SURFACE_CHECK_H

#include "mesh.h"

/** The defect and its triangles; -1: all, or no second one. */
typedef struct surface_fault {
    const char *what; /* and the expected state; NULL: no defect */
    int triangle, other;
} surface_fault;

/**
 * Finds two triangles of the same three vertices, an edge of more than two triangles, an edge
 * between triangles of opposite orientation, or a closed surface that faces inwards: each would
 * change the sign of distances. Open surfaces are accepted. 0, or -1: out of memory.
 */
int surface_check(const mesh *m, surface_fault *fault);

#endif
