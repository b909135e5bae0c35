/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Meshes from Stanford PLY files, ASCII or binary of either byte order. */
#ifndef FABRIC_INPUT_PLY_H
#define FABRIC_INPUT_PLY_H

#include "mesh/mesh.h"

/**
 * Reads the elements `vertex` (x, y, z) and `face` (a list, vertex_indices or vertex_index); others
 * are passed over. Polygons become fans of triangles. Coordinates are the nearest numbers of the
 * type that the header names (so a float is the float that was written); material coordinates are x
 * and y. No edges or hinges yet. 0, or -1 after "file: ..., expected ..." on standard error.
 * mesh_free frees it.
 */
int ply_read(mesh *m, const char *path);

#endif
