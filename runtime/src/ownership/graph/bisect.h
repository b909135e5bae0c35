/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Graph partitioning: parts of equal weight with few edges between them. */
#ifndef REDCC_BISECT_H
#define REDCC_BISECT_H

#include "ownership/graph/neighbours.h"

enum { REDCC_PARTS_MOST = 256 };

/**
 * Divides all nodes into parts 0 ... parts - 1 (at most REDCC_PARTS_MOST); each non-stealable part
 * is followed by `stealable` stealable ones (redcc_amount_below gives their sizes). Recursive
 * bisection: a breadth-first search from a pseudo-peripheral node orders the nodes; the result is
 * refined. Sets part [count]. False: no memory.
 */
bool redcc_divide_graph(const struct graph *graph, uint32_t parts, uint32_t stealable,
                        unsigned char *part);

/**
 * Greedy refinement (after Kernighan-Lin, Fiduccia-Mattheyses) in at most `rounds` rounds. Moves
 * nodes of `list` within [low, high) to parts with stronger edges to them, with equally strong ones
 * if that balances the loads, or out of parts above their limits. load [high] has the parts'
 * weights and is updated, most [high] their limits.
 */
void redcc_refine(const struct graph *graph, const uint32_t *list, uint32_t count,
                  unsigned char *part, uint32_t low, uint32_t high, uint64_t *load,
                  const uint64_t *most, int rounds);

#endif
