/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Graph partitioning: divides the nodes of a graph into parts of given weights with few edges
 * between the parts. */
#ifndef REDCC_BISECT_H
#define REDCC_BISECT_H

#include "ownership/graph/neighbours.h"

enum { REDCC_PARTS_MOST = 256 };

/**
 * Divides all nodes into parts 0 to parts - 1 (at most REDCC_PARTS_MOST parts). Each part that is
 * not stealable is followed by `stealable` stealable ones; redcc_amount_below gives the parts'
 * weights. The method is recursive bisection: a breadth-first search from a pseudo-peripheral node
 * orders the nodes, the order is cut in two, and the result is refined. Sets part[count]. Returns
 * false if out of memory.
 */
bool redcc_divide_graph(const struct graph *graph, uint32_t parts, uint32_t stealable,
                        unsigned char *part);

/**
 * Greedy refinement (after Kernighan-Lin and Fiduccia-Mattheyses) in at most `rounds` rounds. It
 * considers the `count` nodes in `list` whose parts are from `low` to before `high`. It moves a
 * node to the part, among these, to which the node has the strongest edges, if that part has room.
 * A node also moves to a part with equally strong edges if that balances the loads, and out of a
 * part that is above its limit. load[high] has the weights of the parts, and is updated; most[high]
 * has their limits.
 */
void redcc_refine(const struct graph *graph, const uint32_t *list, uint32_t count,
                  unsigned char *part, uint32_t low, uint32_t high, uint64_t *load,
                  const uint64_t *most, int rounds);

#endif
