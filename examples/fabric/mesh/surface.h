/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A closed triangle mesh as a solid: signed distance from any point. The nearest triangle is found
 * in a tree of boxes; the pseudonormal of the nearest face, edge or vertex shows whether the point
 * is inside (Baerentzen and Aanaes 2005: a vertex' normals weighted by their angles). The triangles
 * must be counter-clockwise seen from outside. If the surface is open, the sign is that of the side
 * on which the point is.
 */
#ifndef FABRIC_SURFACE_H
#define FABRIC_SURFACE_H

#include "mesh.h"

typedef struct surface surface;

/** Takes ownership of the mesh, and leaves *m empty. Triangles without area are ignored. NULL with
 * a message in error[256], and *m unchanged: no triangle has area, or out of memory. */
surface *surface_new(mesh *m, char *error);
void surface_free(surface *s);

/** Signed distance of p, negative inside (m), and the unit direction in which it grows. */
double surface_distance(const surface *s, const double p[3], double normal[3]);

/** The largest coordinate in magnitude, m. */
double surface_reach(const surface *s);

/** The vertex' pseudonormal, of any length. */
const double *surface_normal(const surface *s, int vertex);

/** The mesh from which the surface was made. */
const mesh *surface_mesh(const surface *s);

/** A defect and its triangles. */
typedef struct surface_fault {
    const char *what;    /* the defect and the expected state; NULL: no defect */
    int triangle, other; /* triangle -1: all; other -1: no second one */
} surface_fault;

/**
 * Finds two triangles of the same three vertices, an edge of more than two triangles, an edge
 * between triangles of opposite orientation, or a closed surface that faces inwards: each would
 * change the sign of distances. Open surfaces are accepted. 0, or -1: out of memory.
 */
int surface_check(const mesh *m, surface_fault *fault);

#endif
