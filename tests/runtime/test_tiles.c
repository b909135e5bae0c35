/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Tiles of loops over pairs: each pair is executed once, and each element's updates keep the order
 * of the loop. Any number of threads, and tiles of one pair up to one tile for all. */
#include "base/flags.h"
#include "base/memory.h"
#include "execute/tiles.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

enum { MOST = 300, MOST_THREADS = 33 };

static unsigned found[MOST], expected[MOST], seen[MOST][MOST], sum;

/* An update that does not commute with any other. */
static void turn(unsigned *element, int i, int j) {
    element[i] = element[i] * 3 + (unsigned)j;
    if (j != i)
        element[j] = element[j] * 5 + (unsigned)i;
}

static int first_of(int i, bool below) {
    return below ? 0 : i + 1;
}

static int end_of(int i, int trip, bool below) {
    return below ? i + 1 : trip + 1; /* one column more than rows */
}

static void sequentially(unsigned *element, int trip, bool below) {
    for (int i = 0; i < trip; i++)
        for (int j = first_of(i, below); j < end_of(i, trip, below); j++)
            turn(element, i, j);
}

static bool is_slow; /* delays the first band, so that others would overtake it */

static void execute(const redcc_tile *tile, int trip, bool below) {
    if (is_slow && tile->row == 0)
        usleep(2000);
    for (int i = (int)tile->row; i < tile->row_end; i++) {
        int j = first_of(i, below), end = end_of(i, trip, below);
        if (!tile->is_first && j < tile->column)
            j = (int)tile->column;
        if (!tile->is_last && end > tile->column_end)
            end = (int)tile->column_end;
        for (; j < end; j++) {
            turn(found, i, j);
            seen[i][j]++;
        }
    }
}

/* Adds the band's rows in order; these updates do not commute either. */
static void add_band(struct tile_walk *walk, const struct plan *plan) {
    const redcc_tile *tile = &walk->tile;
    redcc_tiles_await_sums(walk, plan);
    if (is_slow && tile->row == 0)
        usleep(2000);
    for (redcc_int i = tile->row; i < tile->row_end; i++)
        sum = sum * 3 + (unsigned)i;
    redcc_tiles_pass_sums(walk, plan);
}

static unsigned sum_of(int trip) {
    unsigned all = 0;
    for (int i = 0; i < trip; i++)
        all = all * 3 + (unsigned)i;
    return all;
}

static void check(struct plan *plan, int trip, int side, bool below) {
    atomic_uint claimed = 0;
    redcc_tile_side = side;
    const struct tile_grid grid = redcc_tile_grid(trip, plan->threads, below);
    memset(found, 0, sizeof found);
    memset(expected, 0, sizeof expected);
    memset(seen, 0, sizeof seen);
    sum = 0;
    sequentially(expected, trip, below);
#pragma omp parallel num_threads(plan->threads)
    {
        struct tile_walk walk;
        redcc_tiles_begin(&walk, grid);
        for (const redcc_tile *tile; (tile = redcc_tiles_next(&walk, plan, &claimed)) != NULL;) {
            execute(tile, trip, below);
            if (tile->is_last)
                add_band(&walk, plan);
        }
    }
    assert_int_equal(sum, sum_of(trip));
    assert_memory_equal(found, expected, sizeof found);
    for (int i = 0; i < trip; i++)
        for (int j = 0; j <= trip; j++)
            assert_int_equal(seen[i][j], j >= first_of(i, below) && j < end_of(i, trip, below));
}

static struct plan plan_of(int threads, unsigned round) {
    struct plan plan = {.method = &redcc_method_tiles, .threads = threads, .round = round};
    plan.flags = redcc_flags_new(redcc_method_tiles.flags((uint32_t)threads));
    assert_non_null(plan.flags);
    return plan;
}

static void updates_keep_their_order(void **unused) {
    (void)unused;
    static const int threads[] = {1, 2, 3, 7, 16, MOST_THREADS};
    static const int trips[] = {1, 2, 3, 16, 17, 64, 201};
    static const int sides[] = {0, 1, 2, 5, 64, 256};
    for (unsigned t = 0; t < sizeof threads / sizeof *threads; t++)
        for (unsigned n = 0; n < sizeof trips / sizeof *trips; n++)
            for (unsigned s = 0; s < sizeof sides / sizeof *sides; s++) {
                if (sides[s] == 1 && trips[n] > 64 && threads[t] > 3)
                    continue; /* would take seconds on a system with few cores */
                struct plan plan = plan_of(threads[t], 1);
                for (; plan.round < 3; plan.round++)
                    check(&plan, trips[n], sides[s], (n + s + plan.round) % 2);
                redcc_memory_free(plan.flags);
            }
}

/* Each round must keep the order, whatever value the flags have from the last one. */
static void no_band_passes_the_first(void **unused) {
    (void)unused;
    struct plan plan = plan_of(3, 1);
    is_slow = true;
    for (; plan.round < 6; plan.round++)
        check(&plan, 64, 16, plan.round % 2);
    is_slow = false;
    redcc_memory_free(plan.flags);
}

/* The flags' values wrap around modulo 2^32. */
static void rounds_go_on(void **unused) {
    (void)unused;
    struct plan plan = plan_of(3, 1);
    for (; plan.round < 300; plan.round++)
        check(&plan, 40, 2, false);
    redcc_memory_free(plan.flags);
    plan = plan_of(3, UINT32_MAX / (20 * 21) - 2);
    for (unsigned last = plan.round; plan.round < last + 6; plan.round++) {
        for (uint32_t flag = 0; plan.round == last && flag < 16 * 5; flag++)
            redcc_flag_raise(plan.flags, flag, (plan.round - 1) * 20 * 21);
        redcc_flag_raise(plan.flags, 16 * 5, plan.round * 20);
        check(&plan, 40, 2, true);
    }
    redcc_memory_free(plan.flags);
}

static void grids_fit(void **unused) {
    (void)unused;
    redcc_tile_side = 0;
    for (redcc_int trip = 1; redcc_can_be_tiled(trip); trip = trip * 3 / 2 + 1)
        for (int threads = 1; threads <= MOST_THREADS; threads += 4) {
            const struct tile_grid grid = redcc_tile_grid(trip, threads, false);
            assert_in_range(grid.side, 1, REDCC_TILE_ROWS);
            assert_in_range(grid.bands, 1, TILES_MOST_BANDS);
            assert_true((redcc_int)grid.bands * grid.side >= trip);
            assert_true((redcc_int)(grid.bands - 1) * grid.side < trip);
        }
    const redcc_int most = (redcc_int)TILES_MOST_BANDS * REDCC_TILE_ROWS;
    assert_true(redcc_can_be_tiled(most));
    assert_int_equal(redcc_tile_grid(most, 2, false).side, REDCC_TILE_ROWS);
    assert_false(redcc_can_be_tiled(most + 1));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(updates_keep_their_order),
                                       cmocka_unit_test(no_band_passes_the_first),
                                       cmocka_unit_test(rounds_go_on), cmocka_unit_test(grids_fit)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
