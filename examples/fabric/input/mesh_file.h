/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Meshes from files of the formats that other programs write. */
#ifndef FABRIC_INPUT_MESH_FILE_H
#define FABRIC_INPUT_MESH_FILE_H

#include "mesh/mesh.h"
#include "mesh/mesh_rest.h"

/**
 * Reads a mesh; its name's ending tells the format: .obj, .ply, and where fabric was built with
 * assimp .gltf, .glb and .stl. Coordinates are what the file has, as metres; z is up, but in glTF y
 * is, and (x, y, z) becomes (x, -z, y). All meshes of a file become one, polygons become triangles.
 * Vertices of glTF and STL with equal coordinates become one, the first: those formats write a
 * vertex more than once. Material coordinates are an OBJ file's vt, else x and y. No edges or
 * hinges yet. 0, or -1 after "file: ..., expected ..." on standard error. mesh_free frees it.
 */
int mesh_file_read(mesh *m, const char *path);

/** Whether files of this name may have material coordinates of their own (an OBJ file's vt). */
int mesh_file_has_texture(const char *path);

/** The line on which triangle 0 <= triangle of the file stands; 0 where the format has no lines of
 *  triangles. */
long mesh_file_line(const char *path, int triangle);

/** What is wrong with a mesh is removed where it cannot stay, and counted: mesh_clean, mesh_connect
 *  and mesh_check in one. Says what was found on standard error, a line a kind, each after `name`.
 *  0, or -1 with a message in error[256]. */
int mesh_file_prepare(mesh *m, const char *name, mesh_problem *found, char *error);

/** Vertices with equal coordinates become one, the first of them; the others' order stays. 0, or
 *  -1: out of memory. */
int mesh_join_vertices(mesh *m);

#endif
