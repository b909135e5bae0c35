/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * tiles: a loop over pairs, `for (i ...) for (j = i + 1; ...) { f[i] += e; f[j] -= e; }`, is cut
 * into tiles: a tile is a band of rows times a block of columns. Each thread executes a separate
 * band, and threads follow each other from block to block (execute/tiles.h). The inspection only
 * finds extents for the overlap guard.
 *
 * Source (loop tiling with a wavefront of tiles): M. Wolfe, More iteration space tiling,
 * Supercomputing 1989.
 */
#include "plan/plan.h"
#include "plan/tile_grid.h"

/* The number of words for flags. Each flag has a cache line of its own. The flags are the progress
 * of each thread's band, the progress of the band above the first of these, and the progress of the
 * sums. The first cache line has no flag. */
static uint32_t flags(uint32_t owners) {
    return TILE_FLAG_WORDS * (owners + 3);
}

/* Sets the expected number of iterations to an equal share. (The number of pairs is unknown.) */
static bool prepare(struct plan *plan, const struct evidence *evidence, int thread) {
    plan->schedule[thread].iterations = redcc_share(evidence->trip, evidence->threads, thread + 1) -
                                        redcc_share(evidence->trip, evidence->threads, thread);
    return true;
}

const struct method redcc_method_tiles = {.name = "tiles",
                                          .keeps = REDCC_ORDER_SERIAL,
                                          .tiles = true,
                                          .flags = flags,
                                          .prepare = prepare};
