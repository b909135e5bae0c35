/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The cloth's triangle mesh with its edges and hinges. SI units throughout. */
#ifndef FABRIC_MESH_H
#define FABRIC_MESH_H

typedef struct mesh {
    int vertex_count;
    int triangle_count;
    int edge_count;
    int hinge_count;
    double (*position)[3]; /* [vertex_count] m, initial positions */
    double (*material)[2]; /* [vertex_count] m, the flat cloth's own coordinates (rest shape) */
    int rest_in_space;     /* each triangle's rest shape follows from `position`, not from
                            * `material` */
    int bent_at_rest;      /* the hinges' rest angles are those in `position`; otherwise they are
                            * 0 */
    int *number;        /* [vertex_count] each vertex's number before mesh_reorder; NULL: unknown */
    int (*triangle)[3]; /* [triangle_count] vertices, counter-clockwise in material coordinates */
    int (*edge)[2];     /* [edge_count] vertices, first < second */
    int (*hinge)[4];    /* [hinge_count] two triangles that share an edge: the edge's two vertices,
                           then the third vertex of each triangle (the wings) */
} mesh;

/** Order of vertices; triangles, edges and hinges are then sorted by their vertices. */
typedef enum mesh_order {
    MESH_ORDER_GENERATED,
    MESH_ORDER_SORTED,   /* reverse Cuthill-McKee */
    MESH_ORDER_SHUFFLED, /* at random */
    MESH_ORDER_HILBERT,  /* along a space-filling curve through the flat cloth */
    MESH_ORDER_DISSECTED /* nested dissection by METIS, if built with it */
} mesh_order;

/**
 * Generates a Delaunay mesh of a square of the given side (m) in the plane z = 0, centred at the
 * origin. Of its `vertices` points, `boundary` lie on the border and the others inside, irregular
 * but of even density. libqhull triangulates them; the seed determines the mesh on any machine. It
 * has 2 * vertices - 2 - boundary triangles. Returns 0, or -1 with a message in error[256].
 */
int mesh_generate(mesh *m, int vertices, int boundary, double side, unsigned seed, char *error);

/** Makes edges and hinges from the triangles. An edge of three triangles or more is counted in
 *  *non_manifold; its first two triangles form the hinge. Returns 0, or -1 with a message in
 *  error[256]. */
int mesh_connect(mesh *m, int *non_manifold, char *error);

/** Renumbers the vertices; `seed` is for the shuffled order. Triangles, edges and hinges are then
 *  sorted by their vertices, except that the shuffled order shuffles them too. new_of_old
 *  [vertex_count] receives the permutation unless it is NULL; with it, results in different orders
 *  can be compared. Returns 0, or -1 with a message in error[256]; the mesh is then unchanged. */
int mesh_reorder(mesh *m, mesh_order order, unsigned seed, int *new_of_old, char *error);

/** Renumbers the vertices by a permutation (`back`: by its inverse, which undoes mesh_reorder), and
 *  sorts triangles, edges and hinges by their vertices. Returns 0, or -1 with a message in
 *  error[256] if new_of_old is no permutation or memory runs out. */
int mesh_renumber(mesh *m, const int *new_of_old, int back, char *error);

/** Returns the mean length of the triangles' sides in `position`, m, or infinity without
 *  triangles. */
double mesh_mean_edge(const mesh *m);

void mesh_free(mesh *m);

#endif
