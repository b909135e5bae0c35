/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Whether a mesh is the surface of a solid, as far as a collider needs it to be (surface.h). */
#ifndef FABRIC_SURFACE_CHECK_H
#define FABRIC_SURFACE_CHECK_H

#include "mesh.h"

/** What is wrong, and of which triangle; -1: of all together, or of no second one. */
typedef struct surface_fault {
    const char *what; /* and what was expected; NULL: nothing is wrong */
    int triangle, other;
} surface_fault;

/**
 * Finds two triangles of the same three vertices, an edge of more than two triangles, an edge along
 * which one triangle faces outwards and the other inwards, or, of a closed surface, that all of it
 * faces inwards: all of which would turn the sign of distances. Surfaces that are not closed are
 * left as they are. 0, or -1: out of memory.
 */
int surface_check(const mesh *m, surface_fault *fault);

#endif
