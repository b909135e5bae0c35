/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Meshes from glTF and STL files, by assimp where that is there. */
#ifndef FABRIC_INPUT_FOREIGN_H
#define FABRIC_INPUT_FOREIGN_H

#include "mesh/mesh.h"

/**
 * Reads all triangles of all nodes into one mesh, each moved by its node's transformations; points
 * and lines are passed over, polygons become triangles. `y_up`: the file's y axis points up, as
 * glTF's does; the mesh's z does: (x, y, z) becomes (x, -z, y). Material coordinates are x and y of
 * the mesh. The reading is done by a process of its own: a damaged file may end that one, but not
 * this. No edges or hinges yet. 0, or -1 after "file: ..." on standard error. mesh_free frees it.
 * Not to be called while other threads run.
 */
int foreign_read(mesh *m, const char *path, int y_up);

#endif
