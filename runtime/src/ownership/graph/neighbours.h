/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A weighted graph: node n's neighbours are neighbour[start[n]] ... neighbour[start[n + 1] - 1]. An
 * edge is stored at both of its nodes, but only at nodes in `only`, if that is set. Parallel edges
 * are stored separately until redcc_graph_merge is called.
 *
 * A node is a unit of the leading group, or a cluster of units. An edge represents an iteration
 * that touches both ends; an iteration with more than four units adds only a ring of edges. Each
 * thread builds the edges of its share of the nodes from all threads' access logs, in the order of
 * the loop. So the graph is independent of the number of threads.
 */
#ifndef REDCC_NEIGHBOURS_H
#define REDCC_NEIGHBOURS_H

#include "ownership/graph/access_log.h"

#include <assert.h>

struct graph {
    uint32_t count;
    uint32_t *start; /* [count + 1] index of each node's first edge */
    uint32_t *neighbour;
    uint32_t *strength; /* the strength of each edge; NULL: 1 each */
    uint32_t *weight;   /* [count] the work of each node */
    /* [count] borrowed: the nodes that may have edges; NULL: all nodes */
    const unsigned char *only;
};

/** Creates `count` nodes. False: out of memory. Call redcc_graph_end in either case. */
bool redcc_graph_begin(struct graph *graph, uint32_t count);

/** Frees the graph's memory. */
void redcc_graph_end(struct graph *graph);

/** The work that an iteration with `units` units contributes to each of them. */
static inline uint32_t redcc_work_of(size_t units) {
    assert(units > 0);
    enum { WORK = 60 };
    return units < WORK ? WORK / (uint32_t)units : 1;
}

/** Counts the edges of nodes [first, end), and sets their weights. The iterations are those of
 * list[0], list[1], ... list[lists - 1]. */
void redcc_graph_count(struct graph *graph, const struct unit_list *const *list, int lists,
                       uint32_t first, uint32_t end);

/** Allocates memory for the edges, when all of them are counted. Returns false if out of memory, or
 * if there are too many edges. */
bool redcc_graph_take(struct graph *graph);

/** Stores the edges of nodes [first, end). */
void redcc_graph_fill(struct graph *graph, const struct unit_list *const *list, int lists,
                      uint32_t first, uint32_t end);

/** Merges parallel edges, adding up their strengths. Removes the edges that are stored at hubs
 * (nodes with too many edges), and edges from a node to itself. False: out of memory. */
bool redcc_graph_merge(struct graph *graph);

#endif
