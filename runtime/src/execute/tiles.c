/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/tiles.h"

#include <assert.h>

void redcc_tiles_begin(struct tile_walk *walk, struct tile_grid grid) {
    assert(grid.trip > 0 && grid.side > 0);
    *walk = (struct tile_walk){.grid = grid};
}

/* The index of a band's flag. Flags are reused: at most as many bands as threads are in progress,
 * and besides theirs only the flag of the band above the first of them is still read. */
static uint32_t flag_of(const struct plan *plan, uint32_t band) {
    return TILE_FLAG_WORDS * (1 + band % ((uint32_t)plan->threads + 1));
}

/* The value of the band's flag after `done` blocks, modulo 2^32. Flags are not reset. Therefore the
 * value grows with the bands that share the flag, and with each execution of the plan. */
static unsigned value_of(const struct plan *plan, const struct tile_grid *grid, uint32_t band,
                         uint32_t done) {
    return (plan->round * grid->bands + band) * (grid->bands + 1) + done;
}

static uint32_t first_block(const struct tile_grid *grid, uint32_t band) {
    return grid->below ? 0 : band;
}

static uint32_t last_block(const struct tile_grid *grid, uint32_t band) {
    return grid->below ? band : grid->bands - 1;
}

static bool take_band(struct tile_walk *walk, atomic_uint *claimed) {
    const uint32_t band = atomic_fetch_add_explicit(claimed, 1, memory_order_relaxed);
    walk->has_band = band < walk->grid.bands;
    if (!walk->has_band)
        return false;
    walk->band = band;
    walk->block = first_block(&walk->grid, band);
    return true;
}

static void pass_on(struct tile_walk *walk, const struct plan *plan) {
    const struct tile_grid *grid = &walk->grid;
    walk->is_handed = false;
    if (walk->block > last_block(grid, walk->band))
        walk->has_band = false;
    redcc_flag_raise(plan->flags, flag_of(plan, walk->band),
                     value_of(plan, grid, walk->band, walk->block));
}

/* sums_flag: the index of the flag that counts the bands whose operands have been added to the
 * sums. sums_of: the value of that flag after `bands` bands. */
static uint32_t sums_flag(const struct plan *plan) {
    return TILE_FLAG_WORDS * ((uint32_t)plan->threads + 2);
}

static unsigned sums_of(const struct tile_walk *walk, const struct plan *plan, uint32_t bands) {
    return plan->round * walk->grid.bands + bands;
}

void redcc_tiles_await_sums(struct tile_walk *walk, const struct plan *plan) {
    assert(walk->is_handed && walk->tile.is_last);
    pass_on(walk, plan);
    if (walk->band > 0)
        redcc_flag_await_past(plan->flags, sums_flag(plan), sums_of(walk, plan, walk->band),
                              plan->threads);
}

void redcc_tiles_pass_sums(const struct tile_walk *walk, const struct plan *plan) {
    redcc_flag_raise(plan->flags, sums_flag(plan), sums_of(walk, plan, walk->band + 1));
}

/* Waits until the band above has finished its tile in this block, if it has one. */
static void await_tile_above(const struct tile_walk *walk, const struct plan *plan) {
    const uint32_t above = walk->band - 1;
    if (walk->band == 0 || walk->block > last_block(&walk->grid, above))
        return;
    redcc_flag_await_past(plan->flags, flag_of(plan, above),
                          value_of(plan, &walk->grid, above, walk->block + 1), plan->threads);
}

const redcc_tile *redcc_tiles_next(struct tile_walk *walk, const struct plan *plan,
                                   atomic_uint *claimed) {
    const struct tile_grid *grid = &walk->grid;
    if (walk->is_handed)
        pass_on(walk, plan);
    if (!walk->has_band && !take_band(walk, claimed))
        return NULL;
    await_tile_above(walk, plan);
    assert(walk->band < grid->bands && walk->block < grid->bands);
    const redcc_int row = (redcc_int)walk->band * grid->side;
    const redcc_int column = (redcc_int)walk->block * grid->side;
    walk->tile =
        (redcc_tile){.row = row,
                     .row_end = grid->trip - row < grid->side ? grid->trip : row + grid->side,
                     .column = column,
                     .column_end = column + grid->side,
                     .is_first = walk->block == first_block(grid, walk->band),
                     .is_last = walk->block == last_block(grid, walk->band)};
    walk->block++;
    walk->is_handed = true;
    return &walk->tile;
}
