/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A weighted graph: node n's neighbours are neighbour[start[n]] ... neighbour[start[n + 1] - 1].
 * Every edge stands at both of its ends; an edge may stand there several times.
 *
 * A node is a unit of the leading group, or a cluster of some; an edge is an iteration that touches
 * two of them (of one that touches more than a few, as a ring). All threads make it together: each
 * the nodes of its own share, from what all were told, in the order of the loop, so that it is the
 * same however many they are.
 */
#ifndef REDCC_NEIGHBOURS_H
#define REDCC_NEIGHBOURS_H

#include "ownership/graph/told.h"

struct graph {
    uint32_t count;
    uint32_t *start; /* [count + 1] */
    uint32_t *neighbour;
    uint32_t *strength;        /* of each edge; NULL: 1 */
    uint32_t *weight;          /* [count] of the nodes: the work that goes with them */
    const unsigned char *only; /* [count] borrowed: which nodes get edges; NULL: all */
};

/** Nodes for `count` units. False: no memory (end it all the same). */
bool redcc_graph_begin(struct graph *graph, uint32_t count);

/** Gives back its memory. */
void redcc_graph_end(struct graph *graph);

/** An iteration's work, shared out among its `units` units: of each. */
static inline uint32_t redcc_work_of(size_t units) {
    enum { WORK = 60 };
    return units < WORK ? WORK / (uint32_t)units : 1;
}

/** Counts the edges of nodes [first, end), and sets their weights. The iterations are those of
 *  list[0], then list[1], ... list[lists - 1]. */
void redcc_graph_count(struct graph *graph, const struct unit_list *const *list, int lists,
                       uint32_t first, uint32_t end);

/** When all nodes' are counted: takes the memory for them. False: none, or too many edges. */
bool redcc_graph_take(struct graph *graph);

/** Enters the edges of nodes [first, end). */
void redcc_graph_fill(struct graph *graph, const struct unit_list *const *list, int lists,
                      uint32_t first, uint32_t end);

/** Makes one edge of those that join the same two nodes, and counts its strength; those of nodes
 *  that everybody is joined to are left out. False: no memory. */
bool redcc_graph_merge(struct graph *graph);

#endif
