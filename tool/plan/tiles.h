/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Tiles of a loop over pairs (runtime: execute/tiles.h):
 *
 *     for (i = 0; i < n; i++)
 *         for (j = i + 1; j < n; j++) { ... f[i] += e; f[j] -= e; }
 *
 *     for (i = 0; i < n; i++) {
 *         double sum = 0;
 *         for (j = i + 1; j < n; j++) { ... sum += e; f[j] -= e; }
 *         f[i] += sum;
 *     }
 *
 * A tile is a band of rows i and a block of columns j. Its turns are executed in the order of the
 * loop, after the tiles above it and to its left.
 *
 * Why it is sound: (i, j) names a turn of the inner loop, and element e of an array the bytes of [S
 * e, S e + S) from a fixed place, S being the array's stride. Turn (i, j) updates bytes of elements
 * i and j only, and j >= i. It reads nothing else that the loop writes: no array (the overlap
 * guard), and no variable of an earlier turn (fresh.h). So it suffices that turns that share an
 * element keep their order. Let e be that element. Turns that update it are (r, e) with r <= e, and
 * (e, c) with c >= e; the loop executes the former by ascending r, and then the latter by ascending
 * c. Of two of them, the one that comes first has neither the later row nor the later column. So it
 * is in the same tile, where rows and columns keep their order, or in one that precedes it. With
 * columns below their rows, j <= i, turns (e, c) come first, by ascending c, and then (r, e) by
 * ascending r; again neither row nor column ever falls.
 *
 * Both counters may have a step of s. Columns then are among the rows' values first + s k, so that
 * elements are named by k, and tiles are cut at such values.
 *
 * What an iteration does before the inner loop and after it belongs to its row. Updates there are
 * of element i, made in the first tile of the row and in the last. So they keep their places in the
 * element's sequence: before all turns (i, c), or after them, with the turns (r, e) of other rows
 * on the same side as without tiles. All else only computes variables of the iteration, without
 * other effects: the statements before the loop are executed again in each tile, those after it in
 * the last tile. Variables that turns or the inner loop's header change and that later turns or
 * statements read (sums of a row), or whose address is taken, are kept from tile to tile: one
 * thread executes the tiles of a row, one after the other, so that turns of a row may even depend
 * on each other. The sums of scalars are kept by row, and each row's operands in the order of its
 * tiles (emit/body/series.h); bands add them one after the other.
 */
#ifndef PLAN_TILES_H
#define PLAN_TILES_H

#include "plan/plan.h"

enum { TILES_MOST_KEPT = 16 };

/** A variable that is kept from tile to tile of a row. */
typedef struct kept_value {
    const ir_variable *variable;
    bool is_unset; /* it has no value before the loop over columns */
} kept_value;

typedef struct tile_plan {
    const char *declined;         /* why there are no tiles; NULL: there are */
    const ir_node *inner;         /* the loop over columns, a statement of the body or all of it */
    const ir_variable *column;    /* its counter */
    const ir_node *lower, *bound; /* first value and bound in its header */
    bool is_inclusive;            /* counter <= bound, not counter < bound */
    bool is_below;                /* columns are below their rows */
    unsigned kept_count;
    kept_value kept[TILES_MOST_KEPT];
} tile_plan;

/** Sets tiles. */
void plan_tiles(loop_plan *plan);

/** Is the statement before the loop over columns, so that only the first tile of a row executes its
 *  updates? */
static inline bool tiles_begin_with(const tile_plan *tiles, const ir_node *statement) {
    return statement->id < tiles->inner->id;
}

/** The plan's tiles; NULL: none. */
static inline const tile_plan *tiles_of(const loop_plan *plan) {
    return plan->tiles && !plan->tiles->declined ? plan->tiles : NULL;
}

#endif
