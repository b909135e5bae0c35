/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Shared by the files that make and change meshes; not for users of a mesh. */
#ifndef FABRIC_MESH_PARTS_H
#define FABRIC_MESH_PARTS_H

#include "mesh.h"

/** Allocates zeroed vertices and triangles, but no edges and no hinges. Returns 0, or -1 and an
 *  empty mesh if out of memory. mesh_free frees it. */
int mesh_allocate(mesh *m, int vertices, int triangles);

/** Neighbours of vertex v: neighbour[start[v]] .. neighbour[start[v + 1] - 1]. A neighbour occurs
 *  once for each triangle of the edge to it, so usually twice. */
typedef struct mesh_graph {
    int vertex_count;
    int *start;
    int *neighbour;
} mesh_graph;

/** Makes the graph of the triangles' edges. Returns 0, or -1 if out of memory. Call mesh_graph_free
 *  in either case. */
int mesh_graph_make(mesh_graph *g, const mesh *m);

void mesh_graph_free(mesh_graph *g);

/** Makes the order along Hilbert's curve through the material coordinates. Returns 0, or -1 if out
 *  of memory. */
int mesh_order_by_curve(const mesh *m, int *new_of_old);

/** Makes the order of a nested dissection. Returns 0, or -1 with a message in error[256] if out of
 *  memory or built without METIS. */
int mesh_order_by_dissection(const mesh *m, int *new_of_old, char *error);

/** Rotates each triangle's vertices so that the lowest comes first, then sorts the triangles. */
void mesh_sort_triangles(mesh *m);

/**
 * Puts `count` points into the square [-1/2, 1/2]^2. The first `boundary` (>= 4, corners included)
 * lie on its border. The others lie inside, irregular but of even density, at least half a spacing
 * from the border. Only +, -, *, / and square roots are used, so the seed determines every bit.
 * points: [count]. Returns 0, or -1 if out of memory.
 */
int mesh_points(double (*points)[2], int count, int boundary, unsigned seed);

#endif
