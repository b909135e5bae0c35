/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The sides of a mesh's triangles, sorted so that the sides of one edge are adjacent. */
#ifndef FABRIC_MESH_SIDES_H
#define FABRIC_MESH_SIDES_H

#include <assert.h>

#include "mesh.h"

typedef struct mesh_side {
    int low, high; /* the side's vertices, ascending */
    int triangle;
    int number; /* 0 to 2: the side goes from this corner of the triangle to the next */
} mesh_side;

/** Returns all sides, [3 * triangle_count], sorted by their vertices, then by triangle; the caller
 *  frees them. Does not use the mesh's edges, which mesh_connect makes. Returns NULL if out of
 *  memory. */
mesh_side *mesh_sides_new(const mesh *m);

/** The vertex of the side's triangle that is not on the side. */
static inline int mesh_side_wing(const mesh *m, const mesh_side *side) {
    assert(side->number >= 0 && side->number < 3);
    return m->triangle[side->triangle][(side->number + 2) % 3];
}

/** Does the triangle traverse the side from the lower vertex to the higher? */
static inline int mesh_side_ascends(const mesh *m, const mesh_side *side) {
    return m->triangle[side->triangle][side->number] == side->low;
}

/** Returns how many of the `count` >= 1 sides at `first` belong to the same edge as the first. */
int mesh_sides_together(const mesh_side *first, int count);

#endif
