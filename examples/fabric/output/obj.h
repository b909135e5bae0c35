/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Meshes as Wavefront OBJ files: v positions, vt material coordinates, f triangles. */
#ifndef FABRIC_OUTPUT_OBJ_H
#define FABRIC_OUTPUT_OBJ_H

#include "mesh/mesh.h"

/** Writes vertices and triangles to a temporary file and renames it; numbers keep every bit. 0,
 *  or -1 after a message on standard error. */
int obj_write(const mesh *m, const char *path);

/**
 * Reads vertices, material coordinates and faces, polygons as fans of triangles; no edges or hinges
 * yet (mesh_connect). Without vt lines, x and y are a vertex' material coordinates. Lines of other
 * kinds are ignored. 0, or -1 after "file:line: ..." on standard error. mesh_free frees it.
 */
int obj_read(mesh *m, const char *path);

/** The line of a triangle, counted from 0, in such a file; 0: the file cannot be read again. */
long obj_triangle_line(const char *path, int triangle);

#endif
