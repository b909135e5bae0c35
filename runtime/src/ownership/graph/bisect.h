/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Dividing a graph into parts of equal weight with few edges between them. */
#ifndef REDCC_BISECT_H
#define REDCC_BISECT_H

#include "ownership/graph/neighbours.h"

enum { REDCC_PARTS_MOST = 256 };

/**
 * Divides all nodes into parts 0 ... parts - 1 (at most REDCC_PARTS_MOST), of which `stealable`
 * after each one are stealable (redcc_amount_below says how large they are): by bisection, each
 * time in the order in which a breadth-first search from a node at the graph's boundary meets the
 * nodes, then refined. part [count] is set. False: no memory.
 */
bool redcc_divide_graph(const struct graph *graph, uint32_t parts, uint32_t stealable,
                        unsigned char *part);

/**
 * Moves nodes of `list` to parts of [low, high) in which they have more neighbours, or as many
 * where that evens out the loads, in at most `rounds` rounds. load [high] is what each part weighs
 * and is kept right, most [high] what it may weigh at most.
 */
void redcc_refine(const struct graph *graph, const uint32_t *list, uint32_t count,
                  unsigned char *part, uint32_t low, uint32_t high, uint64_t *load,
                  const uint64_t *most, int rounds);

#endif
