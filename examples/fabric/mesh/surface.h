/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A triangle mesh as a solid: signed distance from any point. The nearest triangle is found in a
 * tree of boxes. The pseudonormal of the nearest face, edge or vertex shows whether the point is
 * inside (Baerentzen and Aanaes 2005: a vertex's normals weighted by their angles). The
 * triangles must be counter-clockwise seen from outside. If the surface is open, the sign depends
 * on which side of the nearest triangle the point lies.
 */
#ifndef FABRIC_SURFACE_H
#define FABRIC_SURFACE_H

#include "mesh.h"

typedef struct surface surface;

/** Takes ownership of the mesh, and leaves *m empty. Triangles without area are ignored. Returns
 *  NULL with a message in error[256], and leaves *m unchanged, if no triangle has area or memory
 *  runs out. */
surface *surface_new(mesh *m, char *error);
void surface_free(surface *s);

/** Returns the signed distance of p in m, negative inside. `normal` receives the unit direction in
 *  which the distance grows. */
double surface_distance(const surface *s, const double p[3], double normal[3]);

/** The surface's largest coordinate in magnitude, in m. */
double surface_reach(const surface *s);

/** The vertex's pseudonormal, of any length. */
const double *surface_normal(const surface *s, int vertex);

/** The mesh from which the surface was made. */
const mesh *surface_mesh(const surface *s);

/** A defect and its triangles. */
typedef struct surface_fault {
    const char *what;    /* the defect and the expected state; NULL: no defect */
    int triangle, other; /* triangle: -1 for all triangles; other: -1 if there is no second one */
} surface_fault;

/**
 * Looks for a defect that would change the sign of distances: two triangles of the same three
 * vertices, an edge of more than two triangles, an edge between triangles of opposite orientation,
 * or a closed surface that faces inwards. Open surfaces are accepted. *fault receives the first
 * defect found; its `what` is NULL if there is none. Returns 0, or -1 if out of memory.
 */
int surface_check(const mesh *m, surface_fault *fault);

#endif
