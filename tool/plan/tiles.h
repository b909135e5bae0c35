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
 * A tile is a band of rows i and a block of columns j. Its pairs are executed in the order of the
 * loop, after the tiles above it and to its left.
 *
 * Why it is sound: the pair (i, j) is one iteration of the inner loop. Element e of an array is the
 * bytes [S e, S e + S) from a fixed address, where S is the array's stride. Pair (i, j) updates
 * bytes of elements i and j only, and j >= i. It reads nothing else that the loop writes: no array
 * (the overlap guard), and no variable of an earlier pair (fresh.h). So it suffices that pairs that
 * share an element e keep their order. Pairs that update e are (r, e) with r <= e, and (e, c) with
 * c >= e; the loop executes the former by ascending r, and then the latter by ascending c. The
 * earlier of two such pairs has neither a greater row nor a greater column. So it is in the same
 * tile, where rows and columns keep their order, or in a preceding tile. If columns are below
 * their rows, j <= i, pairs (e, c) come first, by ascending c, and then (r, e) by ascending r;
 * again neither row nor column ever decreases.
 *
 * Both counters may have a step s > 1. Then rows and columns are numbers first + s k; elements are
 * named by k, and tiles begin at such numbers.
 *
 * What an iteration does before and after the inner loop belongs to its row. Updates there are of
 * element i: those before the loop are made in the first tile of the row, those after it in the
 * last. So each element's updates keep their order. Those of the row come before or after all pairs
 * (i, c), and pairs (r, i) of other rows stay on the same side of them. The other statements only
 * compute variables of the iteration: those before the inner loop are executed again in each tile,
 * those after it in the last tile. Some variables are kept from tile to tile: those that the inner
 * loop changes and later pairs or statements read (a row's sums), and those whose address is taken.
 * One thread executes the tiles of a row, one after the other, so that pairs of a row may even
 * depend on each other. Operands of scalars are kept by row, in the order of the row's tiles
 * (emit/body/series.h); the bands add them one after the other.
 */
#ifndef PLAN_TILES_H
#define PLAN_TILES_H

#include "plan/plan.h"

enum { TILES_MOST_KEPT = 16 };

/** A variable that is kept from tile to tile of a row. */
typedef struct kept_value {
    const ir_variable *variable;
    bool is_unset; /* the variable has no value before the loop over columns */
} kept_value;

typedef struct tile_plan {
    const char *declined;         /* the reason why there are no tiles; NULL if there are tiles */
    const ir_node *inner;         /* the loop over columns: the body, or a statement in it */
    const ir_variable *column;    /* its counter */
    const ir_node *lower, *bound; /* first value and bound in its header */
    bool is_inclusive;            /* counter <= bound, not counter < bound */
    bool is_below;                /* columns are below their rows */
    unsigned kept_count;
    kept_value kept[TILES_MOST_KEPT];
} tile_plan;

/** Sets plan->tiles. */
void plan_tiles(loop_plan *plan);

/** Is the statement before the loop over columns, so that only the first tile of a row executes its
 *  updates? */
static inline bool tiles_begin_with(const tile_plan *tiles, const ir_node *statement) {
    return statement->id < tiles->inner->id;
}

/** The plan's tiles, or NULL if there are none. */
static inline const tile_plan *tiles_of(const loop_plan *plan) {
    return plan->tiles && !plan->tiles->declined ? plan->tiles : NULL;
}

#endif
