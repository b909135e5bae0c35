/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "reuse/tracking.h"

#include <assert.h>

#include "reuse/pages/watch.h"

enum {
    /* useless tracking of a page costs as much as this many comparisons of a page */
    A_COMPARISON = 12,
    A_SOURCE = 165, /* the check whether a source may be tracked costs as much as this many pages */
    LEAST = 256 * 1024 /* in bytes; comparing fewer bytes costs little more than the query */
};

static double pages_of(struct range pages) {
    return (double)(redcc_range_bytes(pages) / 4096);
}

/* The assumed cost, in seconds, of tracking that turns out to be useless. It doubles with each
 * consecutive failure. Tracking begins when comparisons have cost as much. So useless tracking
 * loses at most as much again (the ski-rental rule). */
static double price(struct range pages, const struct back_off *rest) {
    const double times = rest->length ? (double)rest->length / (LEARN_BACK_OFF / 2.0) : 1;
    return times * LEARN_PAGE * (pages_of(pages) + (double)A_SOURCE);
}

static double compared(struct range pages, uint32_t times) {
    return times * LEARN_PAGE / (double)A_COMPARISON * pages_of(pages);
}

static void back_off(struct tracking *tracking, struct back_off *rest) {
    tracking->stable_count = 0;
    rest->length = redcc_longer(rest->length);
}

/* Called when the source was written: ends tracking. If it has not paid, begins or lengthens the
 * back-off; otherwise resets the back-off. */
static void end_tracking(struct tracking *tracking, struct range pages, struct back_off *rest) {
    if (compared(pages, tracking->skipped) < price(pages, &(struct back_off){0})) {
        back_off(tracking, rest);
    } else {
        tracking->stable_count = 0;
        rest->length = 0;
    }
    tracking->version = 0;
}

/* If another loop tracks the pages already, uses its tracking. Otherwise begins tracking, if past
 * comparisons or the plan's savings cover the cost. Returns the version of the tracked pages; 0:
 * they are not tracked. The cost of an attempt is subtracted from *earned even if the attempt
 * fails. */
static uint64_t begin_tracking(struct tracking *tracking, struct range pages, struct back_off *rest,
                               double *earned) {
    if (redcc_range_bytes(pages) < LEAST)
        return 0;
    const uint64_t shared = redcc_watch_share(pages);
    const double due = price(pages, rest);
    if (shared || (compared(pages, tracking->stable_count) < due && *earned < due))
        return shared;
    *earned -= price(pages, &(struct back_off){0});
    const uint64_t version = redcc_watch_begin(pages);
    if (!version)
        back_off(tracking, rest);
    return version;
}

void redcc_tracking_ask(struct tracking *tracking, struct reading reading, struct back_off *rest,
                        double *earned) {
    const struct range pages = redcc_whole_pages(reading.range);
    if (tracking->version && redcc_readings_equal(tracking->reading, reading)) {
        const enum watch_answer answer = redcc_watch_ask(pages, tracking->version);
        tracking->is_untouched = answer == WATCH_UNTOUCHED;
        tracking->skipped += tracking->is_untouched;
        if (answer != WATCH_TOUCHED)
            return;
        end_tracking(tracking, pages, rest);
    }
    tracking->begun = begin_tracking(tracking, pages, rest, earned);
}

bool redcc_tracking_unchanged(const struct tracking *tracking, struct reading reading) {
    assert(tracking->version != 0);
    return redcc_fingerprint_equal(redcc_reading_ends(reading), tracking->ends);
}

void redcc_tracking_stable(struct tracking *tracking, struct reading reading, long skipped_calls) {
    assert(skipped_calls >= 0);
    const uint64_t stable = tracking->stable_count + 1 + (uint64_t)skipped_calls;
    tracking->stable_count = stable < UINT32_MAX ? (uint32_t)stable : UINT32_MAX;
    if (!tracking->begun)
        return;
    tracking->reading = reading;
    tracking->ends = redcc_reading_ends(reading);
    tracking->version = tracking->begun;
    tracking->skipped = 0;
}
