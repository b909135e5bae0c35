/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reads and checks the meshes of scenes: cloths, and the surfaces of colliders. */
#ifndef FABRIC_INPUT_MESH_FILE_H
#define FABRIC_INPUT_MESH_FILE_H

#include "mesh/mesh.h"
#include "mesh/mesh_rest.h"
#include "mesh/surface.h"

/** Reads an OBJ file (obj.h), whose coordinates are in metres with z up. Returns 0, or -1 after
 *  "file: ..., expected ..." on standard error. mesh_free frees it. */
int mesh_file_read(mesh *m, const char *path);

/** Removes unusable triangles, connects the mesh and checks it: mesh_clean, mesh_connect and
 *  mesh_check. Prints a line that begins with `name` to standard error for each kind of defect.
 *  Returns 0, or -1 with a message in error[256]. */
int mesh_file_prepare(mesh *m, const char *name, mesh_problem *found, char *error);

/** Reads a collider's surface. Returns NULL with a message in error[256] if the file cannot be
 *  read, surface_check finds a defect (the message then also has its position, if known), no
 *  triangle has an area, or memory runs out. */
surface *surface_read(const char *path, char *error);

#endif
