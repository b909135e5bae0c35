/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Self-collision. After the system is solved, velocities are changed so that in the step no vertex
 * passes a triangle and no edge passes an edge, and pairs nearer than the gap separate (Bridson,
 * Fedkiw and Anderson 2002). One pair after the other, in a fixed order, gets equal and opposite
 * impulses along the normal, with friction. impact.h has the number of rounds and the treatment of
 * pairs that still pass.
 *
 * Candidate pairs come from a grid of the triangles' swept boxes. So that no pair is found twice,
 * each vertex and edge is assigned to one of its triangles (Curtis, Tamstorf and Manocha 2008).
 */
#ifndef FABRIC_SELF_COLLISION_H
#define FABRIC_SELF_COLLISION_H

#include <assert.h>

#include "base/arrays.h"
#include "impulse.h"
#include "mesh/mesh.h"

/** Vertex 0 against triangle 1 2 3, or edge 0 1 against edge 2 3. */
typedef struct self_pair {
    int vertex[4];
    int is_edges;
    int is_far;       /* scratch of barrier_pairs.c: the candidate is to be removed */
    int near_at_rest; /* true: corners are within two gaps in the rest shape, so the pair is only
                       * kept from passing */
} self_pair;

/** A search has this number of parts, whatever the number of threads; the parts' results are
 *  concatenated in order. */
enum { SELF_PARTS = 64 };

/** The root of i's tree (union-find with path halving). */
static inline int forest_root(int *parent, int i) {
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

/** First index of part number `part`. */
static inline int self_part_start(int count, int part) {
    assert(part >= 0 && part <= SELF_PARTS);
    return (int)((long)count * part / SELF_PARTS);
}

/** A growing list of pairs. */
typedef struct self_pairs {
    self_pair *pair; /* [count] */
    int count, room;
} self_pairs;

/** Boxes that triangles sweep, sorted into the cells of a grid; see self_grid.c. */
typedef struct self_grid {
    double (*box)[2][3];      /* [triangles] low and high, m */
    double cloth[2][3];       /* m, box around all that the cloth sweeps; set if there are bodies */
    int *owned;               /* [triangles] features assigned to it: bits 0-2 its vertices, 3-5 its
                               * edges 0-1, 1-2, 2-0 */
    int *first;               /* [triangles + 1] each triangle's first entry in `loose` */
    struct self_entry *loose; /* entries sorted by triangle */
    struct self_entry *entry; /* entries sorted by bucket */
    int *start;               /* [buckets + 2] each bucket's first entry */
    int bucket_room, entry_room, loose_room;
    self_pairs part[SELF_PARTS]; /* results of the last search */
} self_grid;

/** Contact of two features: weights of the four vertices, and the unit normal from the second
 *  feature to the first. */
typedef struct self_contact {
    double weight[4];
    double normal[3];
    double distance; /* m, distance along the normal at the step's beginning */
} self_contact;

/** Are a pair's features nearer than the gap at the beginning of the step? */
typedef enum self_start { SELF_UNKNOWN, SELF_APART, SELF_NEAR } self_start;

/** The impulse that a pair needs, and what is known about it since the search: a step's impulses
 *  change velocities, but not where it begins. */
typedef struct self_demand {
    double change; /* m/s, required change of the normal velocity; 0: none */
    self_start start;
    self_contact contact; /* if SELF_NEAR that at the beginning; if SELF_APART its weights are those
                           * of points that were nearest at some moment, or 0 */
} self_demand;

/** Shows which pairs can be skipped: a pair that needed no impulse needs none while its vertices
 *  keep their velocities. Time stamps count rounds and impulses since the search. */
typedef struct self_history {
    int now, round_start; /* the current time; the time at which the current round began */
    int *vertex;          /* [vertices] time of the last change of its velocity */
    double (*v)[3];       /* [vertices] m/s, velocities at the end of the last round */
    int *pair;            /* [pairs] last time at which the pair needed no impulse; -1: never */
    self_demand *demand;  /* [pairs] demand at the round's beginning, for pairs that are not
                           * skipped */
    int pair_room, demand_room;
} self_history;

typedef struct self_collision {
    const mesh *mesh;
    double gap, friction; /* m; no unit */
    double step;     /* s, the scene's step: pairs that are too near separate within a few steps */
    int bodies_from; /* first triangle of bodies; two of these are never a pair */
    self_grid grid;
    self_pair *pair; /* [pair_count] */
    int pair_count, pair_room;
    self_history history;
    int left; /* number of pairs that still pass in the current step */
    long visits;
    arrays own; /* the arrays above whose size is [triangles] or [vertices] */
} self_collision;

/** Keeps a reference to the mesh. Returns 0, or -1 if out of memory. */
int self_collision_init(self_collision *s, const mesh *m, double gap, double friction, double step);
void self_collision_free(self_collision *s);

/** Finds the pairs that may come near in a step of h s from positions x (m) with velocities v
 *  (m/s). Returns 0, or -1 if out of memory or if a number is not finite. */
int self_collision_find(self_collision *s, double h, const double (*x)[3], const double (*v)[3]);

/** Gives one round of impulses, in order, to the pairs that self_collision_find found for this h
 *  and x. Changes v and adds the energy of the impulses to *work (J). Returns the largest change of
 *  a normal velocity, m/s. */
double self_collision_push(self_collision *s, const movable *of, double h, const double (*x)[3],
                           double (*v)[3], double *work);

/** Repeats the search, because the swept boxes changed with the velocities, and counts the passing
 *  pairs in s->left. Returns 0, or -1 if out of memory or if a number is not finite. */
int self_collision_check(self_collision *s, double h, const double (*x)[3], const double (*v)[3]);

/** Do the pair's features pass through each other in the step? */
int self_collision_passes(const self_collision *s, const self_pair *pair, double h,
                          const double (*x)[3], const double (*v)[3]);

/** Finds the pairs that may meet in the step. If `within` is finite, leaves out those whose swept
 *  boxes are more than `within` (m) apart along an axis. Returns 0, or -1 if out of memory or if
 *  a number is not finite. */
int self_grid_find(self_collision *s, double h, const double (*x)[3], const double (*v)[3],
                   double within);

/** Computes the positions of the pair's vertices at the beginning and the end of a step of h s. */
void self_pair_gather(const self_pair *pair, double h, const double (*x)[3], const double (*v)[3],
                      double start[4][3], double end[4][3]);

/** Are the boxes that the two features sweep more than `separation` (m) apart along an axis? Most
 *  pairs are, so this test comes first. */
int self_pair_keeps_distance(const int vertex[4], int is_edges, double separation, double h,
                             const double (*x)[3], const double (*v)[3]);

/** Do the pair's features pass through each other while they move from x to y, both [4]? */
int self_pair_passes(int is_edges, const double x[4][3], const double y[4][3], self_contact *found);

/** Are the features nearer than the gap at y? If so, *found gets the normal and distance at x of
 *  the points that are nearest at y. */
int self_pair_ends_near(int is_edges, const double x[4][3], const double y[4][3], double gap,
                        self_contact *found);

/** Do the features surely stay farther from each other than `distance` while they move from x to y?
 *  Looks only along the line between the points with these weights at x. */
int self_pair_stays_apart(int is_edges, const double x[4][3], const double y[4][3],
                          const double weight[4], double distance);

/** Are the features nearer than the gap at x? */
int self_pair_is_near(int is_edges, const double x[4][3], double gap, self_contact *found);

#endif
