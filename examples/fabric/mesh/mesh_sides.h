/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The sides of a mesh's triangles, those of one edge together. */
#ifndef FABRIC_MESH_SIDES_H
#define FABRIC_MESH_SIDES_H

#include "mesh.h"

typedef struct mesh_side {
    int low, high; /* its vertices, ascending */
    int triangle;
    int number; /* 0 to 2: from the triangle's corner of that number to the next */
} mesh_side;

/** All sides, [3 * triangle_count], sorted by their vertices, then by triangle; to be freed. Does
 * not use the mesh's edges, which mesh_connect makes. NULL: out of memory. */
mesh_side *mesh_sides_new(const mesh *m);

/** The triangle's third vertex. */
static inline int mesh_side_wing(const mesh *m, const mesh_side *side) {
    return m->triangle[side->triangle][(side->number + 2) % 3];
}

/** Does the triangle traverse the side from the lower vertex to the higher? */
static inline int mesh_side_ascends(const mesh *m, const mesh_side *side) {
    return m->triangle[side->triangle][side->number] == side->low;
}

/** How many of the `count` >= 1 sides, from the first on, share the first one's edge. */
int mesh_sides_together(const mesh_side *first, int count);

#endif
