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

/** All [3 * triangle_count], by their vertices, then by triangle; to be freed. Needs no edges
 *  (mesh_connect). NULL: out of memory. */
mesh_side *mesh_sides_new(const mesh *m);

/** The triangle's third vertex. */
static inline int mesh_side_wing(const mesh *m, const mesh_side *side) {
    return m->triangle[side->triangle][(side->number + 2) % 3];
}

/** Does the triangle go along the side from its lower vertex to its higher? */
static inline int mesh_side_ascends(const mesh *m, const mesh_side *side) {
    return m->triangle[side->triangle][side->number] == side->low;
}

/** How many of the `count` >= 1 sides from the first on lie in one edge. */
int mesh_sides_together(const mesh_side *first, int count);

#endif
