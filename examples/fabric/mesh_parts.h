/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the files that make and change meshes share; not for users of a mesh. */
#ifndef FABRIC_MESH_PARTS_H
#define FABRIC_MESH_PARTS_H

#include "mesh.h"

/** Room for vertices and triangles, zeroed; no edges, no hinges. -1 and an empty mesh when memory
 *  is out. mesh_free frees it. */
int mesh_allocate(mesh *m, int vertices, int triangles);

/** Turns each triangle to begin with its lowest vertex, then sorts triangles by their vertices. */
void mesh_sort_triangles(mesh *m);

#endif
