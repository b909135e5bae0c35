/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "library.h"

#include "base/crew.h"
#include "base/safe_load.h"
#include "bins/buffer.h"
#include "execute/ahead.h"
#include "execute/rows.h"
#include "operands.h"
#include "redcc/bins.h"
#include "redcc/entry.h"
#include "series.h"
#include "settings.h"

static void stop_at_misuse(const redcc_worker *worker, const char *rule) {
    const redcc_loop *loop = worker->call->loop;
    redcc_stop("the loop of %s (%s:%d): %s", loop->function, loop->file, loop->line, rule);
}

/* May the pointers be loaded in this execution (redcc_before_calls)? Always if a method is named,
 * if sums are compensated, or under validation, because then every execution must be parallel if
 * possible. Otherwise only if the last execution was long enough ago. */
static int may_load(const redcc_loop *loop, redcc_word *last) {
    const struct settings *settings = redcc_settings_for(loop);
    return settings->method || settings->compensated || settings->validate ||
           redcc_is_time_to_load(last);
}

static const redcc_series_calls series = {.join = redcc_series_join,
                                          .room = redcc_series_room,
                                          .repeats = redcc_series_repeats,
                                          .is_over = redcc_series_is_over,
                                          .has_any = redcc_series_has_any,
                                          .find = redcc_series_find,
                                          .await_band = redcc_series_await_band,
                                          .part_of = redcc_series_part_of,
                                          .end_band = redcc_series_end_band,
                                          .release = redcc_operands_free_all};

static const redcc_behind_calls behind = {.is_readable = redcc_is_readable,
                                          .push_span = redcc_push_span};

static int is_in_order(const redcc_loop *loop) {
    const struct settings *settings = redcc_settings_for(loop);
    return (settings->order_given && settings->order == REDCC_ORDER_SERIAL) ||
           (settings->method && settings->method->keeps == REDCC_ORDER_SERIAL);
}

static const redcc_crew_calls crew = {.arrive = redcc_crew_arrive,
                                      .begin = redcc_crew_begin,
                                      .help = redcc_crew_help,
                                      .end = redcc_crew_end};

static const redcc_before_calls before = {.is_alone = redcc_is_alone,
                                          .may_load = may_load,
                                          .load = redcc_load,
                                          .behind = &behind,
                                          .is_in_order = is_in_order,
                                          .crew = &crew};

const redcc_calls redcc_library = {.version = REDCC_INTERFACE,
                                   .bytes = sizeof(redcc_calls),
                                   .inspect = redcc_inspect,
                                   .flush = redcc_flush,
                                   .is_stale = redcc_is_stale,
                                   .next = redcc_next,
                                   .claims_last = redcc_claims_last,
                                   .hooked = redcc_hooked,
                                   .bins_next = redcc_bins_next,
                                   .push_outside = redcc_push_outside,
                                   .push_block = redcc_push_block,
                                   .least_trip = &redcc_least_trip,
                                   .timed_loops = &redcc_timed_loops,
                                   .sequential_end = redcc_sequential_end,
                                   .fill = redcc_rows_fill,
                                   .settle = redcc_rows_settle,
                                   .misuse = stop_at_misuse,
                                   .series = &series,
                                   .before = &before,
                                   .ahead = &redcc_ahead_library};
