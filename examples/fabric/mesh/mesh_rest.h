/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The rest shape of single triangles, and defects of meshes. */
#ifndef FABRIC_MESH_REST_H
#define FABRIC_MESH_REST_H

#include "mesh.h"

/** A triangle lower than this fraction of its longest edge carries no force: a step moves its
 *  corners by many times its height. */
#define MESH_LEAST_HEIGHT 1e-3

typedef enum mesh_rest_kind {
    MESH_REST_MATERIAL, /* from the material coordinates */
    MESH_REST_POSITION, /* those have no area, or rest_in_space: from where the cloth starts */
    MESH_REST_NONE      /* nor have the positions: no rest shape */
} mesh_rest_kind;

/** The triangle i, j, k flat: uv[0] = (0, 0). Material coordinates that lie in a line, or have less
 *  than 1e-9 of the area that the positions have, are not used. */
mesh_rest_kind mesh_rest_triangle(const mesh *m, int i, int j, int k, double uv[3][2]);

/** The area of all rest shapes together, m^2. */
double mesh_rest_area(const mesh *m);

/** Defects of a mesh, with the number of the first triangle, edge or vertex of each kind. */
enum {
    MESH_FLAT_TRIANGLE,   /* no rest shape: no force */
    MESH_NO_MATERIAL,     /* rest shape from positions */
    MESH_FLIPPED,         /* triangles folded over all their neighbours */
    MESH_SEAM,            /* vertices in the place of another one: not joined there */
    MESH_LONE_VERTEX,     /* of no triangle: held in place */
    MESH_NON_MANIFOLD,    /* edges of more than two triangles: bend at the first two */
    MESH_DUPLICATE,       /* triangles with the vertices of another one: removed by mesh_clean */
    MESH_REPEATED_VERTEX, /* triangles with a vertex twice: removed by mesh_clean */
    MESH_PROBLEM_COUNT
};

typedef struct mesh_problem {
    int count;
    int first; /* -1: there is none */
} mesh_problem;

/** 0, or -1 with a message in error[256]: a coordinate is not finite, or a triangle names a vertex
 *  that does not exist. */
int mesh_check_numbers(const mesh *m, char *error);

/** Removes the triangles that mesh_clean removes, before mesh_connect. Fills those two entries of
 *  found [MESH_PROBLEM_COUNT]. 0, or -1 with a message in error[256]: a number is not finite, a
 *  vertex does not exist, or no triangle is left. */
int mesh_clean(mesh *m, mesh_problem *found, char *error);

/** Adds the other problems but MESH_NON_MANIFOLD, which mesh_connect counts. 0, or -1: out of
 *  memory. */
int mesh_check(const mesh *m, mesh_problem *found);

/** "triangles without area", ... : the kind's name, in the plural. */
const char *mesh_problem_name(int problem);

#endif
