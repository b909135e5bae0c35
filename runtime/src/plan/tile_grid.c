/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/tile_grid.h"

#include <assert.h>

enum {
    BANDS_OF_A_THREAD = 16, /* smallest number of bands per thread; at the end threads are idle for
                               half a band on average */
    LEAST_SIDE = 16, /* with a smaller side, synchronisation would take more than a tenth of a
                        tile's time (16 x 16 pairs) */
    /* with this side, the rows and columns of a tile stay in a core's first-level cache */
    USUAL_SIDE = 128
};

redcc_int redcc_tile_side;

struct tile_grid redcc_tile_grid(redcc_int trip, int threads, bool below) {
    assert(threads >= 1);
    redcc_int side = trip / ((redcc_int)BANDS_OF_A_THREAD * threads);
    const redcc_int least = (trip + TILES_MOST_BANDS - 1) / TILES_MOST_BANDS;
    assert(trip > 0 && redcc_can_be_tiled(trip));
    side = side < LEAST_SIDE ? LEAST_SIDE : side > USUAL_SIDE ? USUAL_SIDE : side;
    side = redcc_tile_side > 0 ? redcc_tile_side : side;
    side = side < least ? least : side;
    return (struct tile_grid){trip, side, (uint32_t)((trip + side - 1) / side), below};
}
