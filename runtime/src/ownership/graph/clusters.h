/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Clusters are sets of some dozens of units (rows) that iterations connect. The graph of the
 * clusters is so small that a careful partition of it is cheap, and a partition of the clusters is
 * also a partition of the units. This is the coarsening of multilevel partitioners (Karypis and
 * Kumar), but computed directly from the access log, without a graph of the units.
 *
 * In each round every node (a unit, later a cluster) chooses a node: the node of lowest rank among
 * itself and all nodes to which iterations connect it. Ranks come from a hash. The choices form
 * trees: a node that chooses itself is a root. Each tree becomes one node of the next round
 * (Boruvka's hooking), or several if it is too large or too deep. A round reduces a mesh's nodes by
 * a factor of about seven. All threads process their iterations concurrently; the result is
 * independent of the number of threads.
 *
 *     begin    one thread
 *     choose   each thread: its iterations
 *     agree    each thread: some nodes       repeatedly,
 *     join     one thread                    until join returns false
 *     map      each thread: its iterations
 *
 * All threads synchronise between any two of these steps. Directly before map, each thread calls
 * place for some units.
 */
#ifndef REDCC_CLUSTERS_H
#define REDCC_CLUSTERS_H

#include "ownership/graph/access_log.h"

/** One thread's part in computing the clusters. */
struct cluster_share {
    const struct unit_list *logged; /* the units of each iteration */
    struct unit_list list;          /* the clusters of each iteration that has several */
    uint32_t *choice; /* [nodes] the rank that each node chooses, considering only this thread's
                         iterations; in share[0], finally all iterations */
    uint32_t *weight; /* [count] the work of each cluster, counting only this thread's iterations;
                         in share[0], finally all iterations */
};

struct clusters {
    uint32_t units;
    uint32_t most;   /* maximum number of units of a cluster */
    uint32_t nodes;  /* number of nodes before the last round */
    uint32_t count;  /* current number of clusters; before the first round, the number of units */
    uint32_t *of;    /* [units] the cluster of each unit; REDCC_NO_UNIT: it is not touched */
    uint32_t *into;  /* [nodes] the cluster of each node */
    uint32_t *size;  /* [count] number of units of each cluster */
    uint32_t *spare; /* [count] scratch memory */
    int rounds;
    int threads;
    struct cluster_share *share; /* [threads] */
};

/** Begins, with each of the `units` units as a cluster. Uses the lists `leading` of
 * logged[threads], which the caller keeps. Returns false if out of memory. Call redcc_clusters_end
 * in either case. */
bool redcc_clusters_begin(struct clusters *clusters, uint32_t units, uint32_t most,
                          const struct access_log *logged, int threads);

/** Frees the memory. */
void redcc_clusters_end(struct clusters *clusters);

/** Computes the choice of each unit, considering only this thread's iterations. */
void redcc_clusters_choose(struct clusters *clusters, int thread);

/** Combines the choices of nodes [first, end) over all threads; after the first round also their
 * weights. */
void redcc_clusters_agree(struct clusters *clusters, uint32_t first, uint32_t end);

/** Joins nodes to clusters of at most `most` units. Returns false and joins nothing if the clusters
 * are few enough, if the second or a later round merged less than half of the nodes, or after six
 * rounds. */
bool redcc_clusters_join(struct clusters *clusters);

/** Stores the new cluster of each of the units [first, end). */
void redcc_clusters_place(struct clusters *clusters, uint32_t first, uint32_t end);

/** Replaces the nodes in the thread's lists of iterations by their clusters, and computes the
 * choices of these clusters. */
void redcc_clusters_map(struct clusters *clusters, int thread);

#endif
