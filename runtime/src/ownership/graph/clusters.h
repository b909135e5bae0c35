/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Clusters: some dozens of units each that iterations join. Their graph is small enough to be
 * divided with care at no cost, and a division of it is one of the units: the coarsening of
 * multilevel partitioners (Karypis and Kumar), straight from what was told, without a graph of the
 * units.
 *
 * In each round every node (a unit, later a cluster) chooses, of all that iterations join it to and
 * itself, the one that comes first in an order drawn by hashing; who chooses itself is the root of
 * a tree of those that lead to it, and trees are the nodes of the next round (Boruvka's hooking). A
 * round divides a mesh's nodes by about seven. All threads go through their iterations side by
 * side; the result is the same however many they are.
 *
 *     begin    one thread
 *     choose   each thread: its iterations
 *     agree    each thread: some nodes      again and again,
 *     join     one thread                   until join says that there are few enough
 *     retell   each thread: its iterations
 *
 * Between any two of them all threads meet.
 */
#ifndef REDCC_CLUSTERS_H
#define REDCC_CLUSTERS_H

#include "ownership/graph/told.h"

/** Of one thread. */
struct cluster_share {
    const struct unit_list *told; /* the units of each iteration */
    struct unit_list list;        /* the clusters of each iteration that has several */
    uint32_t *choice;             /* [nodes] by this thread's iterations; of thread 0: by all */
    uint32_t *weight;             /* [count] work of each; of thread 0: of all */
};

struct clusters {
    uint32_t units;
    uint32_t most;   /* units of a cluster */
    uint32_t nodes;  /* that the last round has joined */
    uint32_t count;  /* clusters there are now; before the first round: units */
    uint32_t *of;    /* [units] the cluster of each; REDCC_NO_UNIT: nothing touches it */
    uint32_t *into;  /* [nodes] the cluster of each */
    uint32_t *size;  /* [count] units of each */
    uint32_t *spare; /* [count] */
    int rounds;
    int threads;
    struct cluster_share *share; /* [threads] */
};

/** Begins, each of `units` units for itself; of told [threads] the leading lists are borrowed.
 *  False: no memory (end it all the same). */
bool redcc_clusters_begin(struct clusters *clusters, uint32_t units, uint32_t most,
                          const struct told *told, int threads);

/** Gives back its memory. */
void redcc_clusters_end(struct clusters *clusters);

/** What the units choose by the thread's iterations. */
void redcc_clusters_choose(struct clusters *clusters, int thread);

/** What nodes [first, end) choose, and weigh, by all. */
void redcc_clusters_agree(struct clusters *clusters, uint32_t first, uint32_t end);

/** Joins nodes to clusters of at most `most` units. False: there are few enough, and nothing is
 *  done. */
bool redcc_clusters_join(struct clusters *clusters);

/** Notes the clusters of units [first, end). */
void redcc_clusters_place(struct clusters *clusters, uint32_t first, uint32_t end);

/** The thread's iterations by clusters; and what those choose. */
void redcc_clusters_retell(struct clusters *clusters, int thread);

#endif
