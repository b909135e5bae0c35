/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The tiles of a loop over pairs. Rows (the loop's iterations) are cut into bands, and columns (the
 * values of the inner counter) into blocks at the same values. Tile (I, J) is band I times block J:
 *
 *     J    0  1  2  3            Each letter is a tile, executed by thread a or b. A thread takes a
 *   I 0    a  a  a  a            band and executes its tiles from left to right, each after the
 * tile 1       b  b  b            above it. Then it takes the next band that no thread has taken.
 * In 2          a  a            this example thread b follows thread a, one block behind it. 3 b
 *
 * Before tile (I, J), all other tiles (I', J') with I' <= I and J' <= J are done: those on its left
 * by the same thread, and by induction those above. So of two pairs that have an element in common,
 * the one that comes first in the loop is executed first (docs/soundness.md).
 *
 * Bands are taken in order, and a thread waits only for a band before its own, so the thread with
 * the first unfinished band never waits. The operands of floating sums are added band by band
 * (redcc/series.h).
 */
#ifndef REDCC_EXECUTE_TILES_H
#define REDCC_EXECUTE_TILES_H

#include "plan/plan.h"
#include "plan/tile_grid.h"

#include <stdbool.h>

/** One thread's position in the grid. */
struct tile_walk {
    struct tile_grid grid;
    uint32_t band;
    uint32_t block;  /* number of the band's next block */
    redcc_tile tile; /* the tile that was handed out last */
    bool has_band;
    bool is_handed; /* the tile before `block` was handed out; the next call marks it as done */
};

void redcc_tiles_begin(struct tile_walk *walk, struct tile_grid grid);

/** Waits until the next tile of the thread may be executed, and returns this tile. *claimed counts
 * the bands that threads have taken. NULL: no tile is left. */
const redcc_tile *redcc_tiles_next(struct tile_walk *walk, const struct plan *plan,
                                   atomic_uint *claimed);

/** Called after the last tile of the thread's band: waits until the operands of all bands above
 * have been added to the sums. */
void redcc_tiles_await_sums(struct tile_walk *walk, const struct plan *plan);

/** Signals that the operands of the thread's band have been added. */
void redcc_tiles_pass_sums(const struct tile_walk *walk, const struct plan *plan);

#endif
