/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The rest shape of single triangles, and defects of meshes. */
#ifndef FABRIC_MESH_REST_H
#define FABRIC_MESH_REST_H

#include "mesh.h"

/** A triangle whose height is below this fraction of its longest edge carries no force: a step
 * would move its corners by many times its height. */
#define MESH_LEAST_HEIGHT 1e-3

typedef enum mesh_rest_kind {
    MESH_REST_MATERIAL, /* from the material coordinates */
    MESH_REST_POSITION, /* from the initial positions, if rest_in_space or without area in
                         * `material` */
    MESH_REST_NONE      /* no rest shape: the positions have no area either */
} mesh_rest_kind;

/** Computes the flat rest shape uv (m) of the triangle i, j, k, with uv[0] = (0, 0). Collinear
 *  material coordinates, and those with less than 1e-9 of the positions' area, are not used. */
mesh_rest_kind mesh_rest_triangle(const mesh *m, int i, int j, int k, double uv[3][2]);

/** The area of all rest shapes together, m^2. */
double mesh_rest_area(const mesh *m);

/** Kinds of defects of a mesh. */
enum {
    MESH_FLAT_TRIANGLE, /* no rest shape: no force */
    MESH_NO_MATERIAL,   /* rest shape from positions */
    MESH_FLIPPED,       /* triangles folded over their neighbours */
    MESH_SEAM,          /* vertices at the position of another one: the mesh is not joined there */
    MESH_LONE_VERTEX,   /* vertices in no triangle: held in place */
    MESH_NON_MANIFOLD,  /* edges of more than two triangles: only the first two make a hinge */
    MESH_DUPLICATE,     /* triangles with the vertices of another one: removed by mesh_clean */
    MESH_REPEATED_VERTEX, /* triangles with a vertex twice: removed by mesh_clean */
    MESH_PROBLEM_COUNT
};

typedef struct mesh_problem {
    int count;
    int first; /* index of the first triangle, edge or vertex with the defect; -1 if none */
} mesh_problem;

/** Returns 0, or -1 with a message in error[256] if a coordinate is not finite or a triangle names
 *  a vertex that does not exist. */
int mesh_check_numbers(const mesh *m, char *error);

/** Removes duplicate triangles and those with a vertex twice; to be called before mesh_connect.
 *  Counts the removed ones in their entries of found [MESH_PROBLEM_COUNT], and sets all other
 *  entries to none. Returns 0, or -1 with a message in error[256] if a number is not finite, a
 *  vertex does not exist, no triangle is left, or memory runs out. */
int mesh_clean(mesh *m, mesh_problem *found, char *error);

/** Finds all other problems except MESH_NON_MANIFOLD, which mesh_connect counts. Returns 0, or -1
 *  if out of memory. */
int mesh_check(const mesh *m, mesh_problem *found);

/** The name of a kind of defect in the plural, such as "triangles without area". */
const char *mesh_problem_name(int problem);

#endif
