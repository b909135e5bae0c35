/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Macros for tiles: a body that is clipped to some of the columns. loop.h includes this file.
 */
#ifndef REDCC_TILES_H
#define REDCC_TILES_H

#include <redcc/entry.h>

/** For each iteration of a tile, its turns from column redcc__from to before redcc__to. */
#define REDCC_TILE_PARAMETERS                                                                      \
    redcc_worker *const redcc__worker __attribute__((__unused__)),                                 \
        const redcc_tile *const redcc__tile __attribute__((__unused__)),                           \
        const redcc_int redcc__from, const redcc_int redcc__to
#define REDCC_TILE_ARGUMENTS redcc__worker, &redcc__tile, redcc__from, redcc__to
#define REDCC_TILE_FROM(redcc_type, redcc_lower)                                                   \
    (redcc__from > (redcc_int)(redcc_lower) ? (redcc_type)redcc__from : (redcc_type)(redcc_lower))
#define REDCC_TILE_TO(redcc_type, redcc_bound)                                                     \
    (redcc__to < (redcc_int)(redcc_bound) ? (redcc_type)redcc__to : (redcc_type)(redcc_bound))
/** The same for counter <= bound. */
#define REDCC_TILE_UP_TO(redcc_type, redcc_bound)                                                  \
    (redcc__to - 1 < (redcc_int)(redcc_bound) ? (redcc_type)(redcc__to - 1)                        \
                                              : (redcc_type)(redcc_bound))

/** In front of a chunk's declarations: what is handed out may be a tile. Both counters have this
 *  step. */
#define REDCC_TILED(redcc_step, redcc_call_of_tile, redcc_after_tile)                              \
    if (__builtin_expect(redcc__asked == REDCC_TILE, 0)) {                                         \
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

#endif
