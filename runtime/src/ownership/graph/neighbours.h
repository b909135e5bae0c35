/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A weighted graph: node n's neighbours are neighbour[start[n]] ... neighbour[start[n + 1] - 1].
 * Every edge stands at both of its ends; an edge may stand there several times.
 *
 * The access graph has a node for each unit of the leading group, and an edge for each iteration
 * that touches two units (of one that touches more than a few, as a ring). All threads make it
 * together: each the nodes of its own share, from what all were told, in the order of the loop, so
 * that it is the same however many they are.
 */
#ifndef REDCC_NEIGHBOURS_H
#define REDCC_NEIGHBOURS_H

#include "ownership/graph/told.h"

struct graph {
    uint32_t count;
    uint32_t *start; /* [count + 1] */
    uint32_t *neighbour;
    uint32_t *strength; /* of each edge; NULL: 1 */
    uint32_t *weight;   /* [count] of the nodes: the work that goes with them */
};

/** Nodes for `count` units. False: no memory (end it all the same). */
bool redcc_graph_begin(struct graph *graph, uint32_t count);

/** Gives back its memory. */
void redcc_graph_end(struct graph *graph);

/** Counts the edges of nodes [first, end), and sets their weights. */
void redcc_graph_count(struct graph *graph, const struct told *const *told, int threads,
                       uint32_t first, uint32_t end);

/** When all nodes' are counted: takes the memory for them. False: none, or too many edges. */
bool redcc_graph_take(struct graph *graph);

/** Enters the edges of nodes [first, end). */
void redcc_graph_fill(struct graph *graph, const struct told *const *told, int threads,
                      uint32_t first, uint32_t end);

#endif
