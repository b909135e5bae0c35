/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Clusters: some dozens of neighbouring nodes of a graph each. The graph of clusters is small
 * enough to be divided with care at no cost, and a division of it is one of the graph: the
 * coarsening of multilevel partitioners (Karypis and Kumar), in one step, by growth from a seed
 * instead of by matchings.
 */
#ifndef REDCC_CLUSTERS_H
#define REDCC_CLUSTERS_H

#include "ownership/graph/neighbours.h"

struct clusters {
    uint32_t count;
    uint32_t *of;     /* [nodes] the cluster of each node */
    uint32_t *member; /* [nodes] the nodes, cluster after cluster */
    uint32_t *start;  /* [count + 1] cluster c: member[start[c]] ... member[start[c + 1] - 1] */
};

/** Edges between clusters, of some of them. */
struct cluster_edges {
    uint32_t *to;
    uint32_t *strength;
    size_t count;
    size_t capacity;
};

/** Grows clusters of at most `most` nodes each. False: no memory (end it all the same). */
bool redcc_clusters_begin(struct clusters *clusters, const struct graph *graph, uint32_t most);

/** Gives back its memory. */
void redcc_clusters_end(struct clusters *clusters);

/** The edges of clusters [first, end): coarse->start[c + 1] becomes the number of those of c, and
 *  coarse->weight[c] its weight. Threads may do different ones at the same time. False: no memory.
 */
bool redcc_clusters_edges(const struct clusters *clusters, const struct graph *graph,
                          uint32_t first, uint32_t end, struct graph *coarse,
                          struct cluster_edges *edges);

/** Gives back its memory. */
void redcc_cluster_edges_end(struct cluster_edges *edges);

#endif
