/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The division of a loop over pairs into tiles. execute/tiles.h has a drawing of it. */
#ifndef REDCC_PLAN_TILE_GRID_H
#define REDCC_PLAN_TILE_GRID_H

#include "redcc/runtime.h"

#include <stdbool.h>
#include <stdint.h>

enum {
    TILES_MOST_BANDS = 8192,
    TILE_FLAG_WORDS = 16 /* number of words for each band's flag: a whole cache line */
};

/** For tests: number of rows of a band; 0: it is computed. */
extern redcc_int redcc_tile_side;

/** The division of a loop into tiles. */
struct tile_grid {
    redcc_int trip;
    redcc_int side; /* number of rows of a band, and of columns of a block */
    uint32_t bands;
    bool below; /* column numbers are below row numbers */
};

/** Can a loop with this number of iterations be divided into tiles? */
static inline bool redcc_can_be_tiled(redcc_int trip) {
    return trip <= (redcc_int)TILES_MOST_BANDS * REDCC_TILE_ROWS;
}

struct tile_grid redcc_tile_grid(redcc_int trip, int threads, bool below);

#endif
