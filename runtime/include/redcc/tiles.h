/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops over pairs: the counter of the inner loop is above (or below) that of the outer one. Their
 * iterations are executed by tiles: a function executes the part of an outer iteration whose inner
 * counter is in a range of columns. This file also counts the inner iterations before an outer one.
 * loop.h includes it.
 */
#ifndef REDCC_TILES_H
#define REDCC_TILES_H

#include <redcc/entry.h>

/** Parameters of a function that executes one outer iteration of a tile: those of its inner
 * iterations whose counter is at least redcc__from and less than redcc__to. */
#define REDCC_TILE_PARAMETERS                                                                      \
    redcc_worker *const redcc__worker __attribute__((__unused__)),                                 \
        const redcc_tile *const redcc__tile __attribute__((__unused__)),                           \
        const redcc_int redcc__from, const redcc_int redcc__to
#define REDCC_TILE_ARGUMENTS redcc__worker, &redcc__tile, redcc__from, redcc__to
#define REDCC_TILE_FROM(redcc_type, redcc_lower)                                                   \
    (redcc__from > (redcc_int)(redcc_lower) ? (redcc_type)redcc__from : (redcc_type)(redcc_lower))
#define REDCC_TILE_TO(redcc_type, redcc_bound)                                                     \
    (redcc__to < (redcc_int)(redcc_bound) ? (redcc_type)redcc__to : (redcc_type)(redcc_bound))
/** As REDCC_TILE_TO, for an inner loop with the condition counter <= bound. */
#define REDCC_TILE_UP_TO(redcc_type, redcc_bound)                                                  \
    (redcc__to - 1 < (redcc_int)(redcc_bound) ? (redcc_type)(redcc__to - 1)                        \
                                              : (redcc_type)(redcc_bound))

/** Precedes a chunk's declarations: if redcc_next handed out a tile, executes it. Both counters
 * have the step redcc_step. */
#define REDCC_TILED(redcc_step, redcc_call_of_tile, redcc_after_tile)                              \
    if (__builtin_expect(redcc__chunk_kind == REDCC_TILE, 0)) {                                    \
        const redcc_tile redcc__tile = *redcc__worker->variant.tile;                               \
        const redcc_int redcc__from = redcc__tile.is_first                                         \
                                          ? -__LONG_LONG_MAX__                                     \
                                          : redcc__lower + (redcc_step)*redcc__tile.column;        \
        const redcc_int redcc__to = redcc__tile.is_last                                            \
                                        ? __LONG_LONG_MAX__                                        \
                                        : redcc__lower + (redcc_step)*redcc__tile.column_end;      \
        for (redcc__k = redcc__tile.row; redcc__k < redcc__tile.row_end; redcc__k++)               \
            redcc_call_of_tile;                                                                    \
        redcc_after_tile continue;                                                                 \
    }

/* m (m - 1) / 2 modulo 2^64 */
REDCC_INLINE redcc_word redcc_pairs(redcc_word m) {
    return m % 2 ? m * ((m - 1) / 2) : m / 2 * (m - 1);
}

/** The number of inner iterations of rows 0 to k - 1. Row r has first - r inner iterations, or none
 * if this is negative. */
REDCC_INLINE redcc_word redcc_inner_trips_above(redcc_int first, redcc_int k) {
    const redcc_word rows = (redcc_word)(first < 0 ? 0 : first < k ? first : k);
    return rows * (redcc_word)first - redcc_pairs(rows);
}

/** As redcc_inner_trips_above, if row r has first + r inner iterations, or none if this is
 * negative. */
REDCC_INLINE redcc_word redcc_inner_trips_below(redcc_int first, redcc_int k) {
    const redcc_int empty = first < 0 ? -first : 0;
    const redcc_word rows = (redcc_word)(k < empty ? 0 : k - empty);
    return rows * (redcc_word)(first + empty) + redcc_pairs(rows);
}

#endif
