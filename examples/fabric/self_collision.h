/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Cloth against itself. After the system is solved, velocities are changed so that in the step no
 * vertex goes through a triangle and no edge through an edge, and those nearer than the gap draw
 * apart (Bridson, Fedkiw and Anderson 2002): equal and opposite impulses along the normal, with
 * friction, one pair after the other in a fixed order, several times. What is left after that is
 * counted; the monitor then rejects the step.
 *
 * Pairs that may meet are found in a grid of the boxes that the triangles sweep; each vertex and
 * edge is tested for one of its triangles alone (Curtis, Tamstorf and Manocha 2008).
 */
#ifndef FABRIC_SELF_COLLISION_H
#define FABRIC_SELF_COLLISION_H

#include "mesh.h"

/** Vertex 0 against triangle 1 2 3, or edge 0 1 against edge 2 3. */
typedef struct self_pair {
    int vertex[4];
    int is_edges;
    int near_at_rest; /* too near in the flat cloth to be kept apart: only kept from passing */
} self_pair;

/** Boxes that triangles sweep, sorted into the cells of a grid; see self_grid.c. */
typedef struct self_grid {
    double (*box)[2][3]; /* [triangles] low and high, m */
    int *owned;          /* [triangles] bits 0-2: its vertices, 3-5: its edges 0-1, 1-2, 2-0 */
    int *start;          /* [buckets + 1] */
    struct self_entry *entry;
    int bucket_room, entry_room;
} self_grid;

typedef struct self_collision {
    const mesh *mesh;
    double gap, friction; /* m */
    double step;          /* s, the scene's: what is too near draws apart within some of these */
    self_grid grid;
    self_pair *pair; /* [pair_count] */
    int pair_count, pair_room;
    int failed; /* out of memory, or the step ends in something not finite */
    int left;   /* pairs that still pass through each other, of the step treated last */
    long visits;
} self_collision;

/** The mesh by reference. 0, or -1: out of memory. */
int self_collision_init(self_collision *s, const mesh *m, double gap, double friction, double step);
void self_collision_free(self_collision *s);

/** A step of h s from positions x (m) with velocities v (m/s): changes v. inverse_mass [vertices]
 *  1/kg, 0 for what is held. Returns the energy that took, J. */
double self_collision_resolve(self_collision *s, double h, const double *inverse_mass,
                              const double (*x)[3], double (*v)[3]);

/** Finds the pairs that may meet in the step; 0, or -1: out of memory, or not all is finite. */
int self_grid_find(self_collision *s, double h, const double (*x)[3], const double (*v)[3]);

/** How two features meet: weights of the four vertices' velocities, the normal from the second
 *  feature to the first, and how far apart they are at the start. */
typedef struct self_contact {
    double weight[4];
    double normal[3];
    double distance; /* m, along the normal at the start */
} self_contact;

/** Do the pair's features pass through each other on the way from x to y, all [4]? */
int self_pair_passes(int is_edges, const double x[4][3], const double y[4][3], self_contact *found);

/** Are they nearer than the gap at x? */
int self_pair_is_near(int is_edges, const double x[4][3], double gap, self_contact *found);

#endif
