/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Meshes as Wavefront OBJ files: v positions, vt material coordinates, f triangles. */
#ifndef FABRIC_OUTPUT_OBJ_H
#define FABRIC_OUTPUT_OBJ_H

#include "mesh/mesh.h"

/** Writes vertices and triangles to a temporary file and renames it. Numbers keep every bit.
 *  Returns 0, or -1 after a message on standard error. */
int obj_write(const mesh *m, const char *path);

/**
 * Reads vertices, material coordinates and faces; a polygon becomes a fan of triangles.
 * mesh_connect adds edges and hinges. Without vt lines, x and y are a vertex's material
 * coordinates. Lines of other kinds are ignored. Returns 0, or -1 after "file:line: ..." on
 * standard error. mesh_free frees the mesh.
 */
int obj_read(mesh *m, const char *path);

/** Returns the line (from 1) of a triangle (from 0) in such a file, or 0 if the file cannot be read
 *  again. */
long obj_triangle_line(const char *path, int triangle);

#endif
