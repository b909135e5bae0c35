/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "reuse/tracking.h"

#include "reuse/pages/watch.h"

/* To protect a page takes 0.1 microseconds, a write to it then 1.3 once; to compare it, 0.12 (4096
 * bytes at 35 GB/s). To look whether a source may be tracked takes some 250, whatever its size. */
static const double a_comparison = 0.12e-6; /* of a page, in seconds */
enum {
    A_PAGE = 12,             /* comparisons of it that cost as much as to track it for nothing */
    A_SOURCE = 2048,         /* pages that are compared meanwhile */
    COMPARED_AT_ONCE = 4096, /* bytes, of these measures */
    BACKOFF_MOST = 16,
    LEAST = 256 * 1024 /* bytes; to compare fewer costs little more than to ask */
};

static size_t compared_pages(struct range pages) {
    return redcc_range_bytes(pages) / COMPARED_AT_ONCE;
}

/* After so many comparisons, which have cost as much as tracking the pages may cost for nothing, it
 * is begun: that loses at most as much again (the rule of ski rental). */
static uint32_t threshold(struct range pages) {
    return (uint32_t)(A_PAGE + A_SOURCE / compared_pages(pages));
}

/* Seconds that they take. */
static double price(struct range pages) {
    return a_comparison * threshold(pages) * (double)compared_pages(pages);
}

/* It did not pay: exponential back-off. */
static void back_off(struct tracking *tracking, unsigned *backoff) {
    tracking->stable_count = 0;
    if (*backoff < BACKOFF_MOST)
        ++*backoff;
}

/* The source was written to: was it worth it? */
static void end_tracking(struct tracking *tracking, struct range pages, unsigned *backoff) {
    if (tracking->skipped >= threshold(pages)) {
        tracking->stable_count = 0;
        *backoff = 0;
    } else
        back_off(tracking, backoff);
    tracking->version = 0;
}

/* Is it time: by comparisons, or because the plan has saved what it may cost for nothing? */
static bool is_due(const struct tracking *tracking, struct range pages, unsigned backoff,
                   double earned) {
    return tracking->stable_count >= (uint64_t)threshold(pages) << backoff ||
           earned >= price(pages) * (double)(1u << backoff);
}

/* The version from which on the pages are tracked, where they are by now; 0: not yet. Where they
 * cannot be, it has cost something to find that out. */
static uint64_t begin_tracking(struct tracking *tracking, struct range pages, unsigned *backoff,
                               double *earned) {
    if (redcc_range_bytes(pages) < LEAST)
        return 0;
    const uint64_t shared = redcc_watch_share(pages);
    if (shared || !is_due(tracking, pages, *backoff, *earned))
        return shared;
    *earned -= price(pages);
    const uint64_t version = redcc_watch_begin(pages);
    if (!version)
        back_off(tracking, backoff);
    return version;
}

void redcc_tracking_ask(struct tracking *tracking, struct reading reading, unsigned *backoff,
                        double *earned) {
    const struct range pages = redcc_whole_pages(reading.range);
    if (tracking->version && redcc_readings_equal(tracking->reading, reading)) {
        const enum watch_answer answer = redcc_watch_ask(pages, tracking->version);
        tracking->stands = answer == WATCH_UNTOUCHED;
        tracking->skipped += tracking->stands;
        if (answer != WATCH_TOUCHED)
            return;
        end_tracking(tracking, pages, backoff);
    }
    tracking->begun = begin_tracking(tracking, pages, backoff, earned);
}

bool redcc_tracking_unchanged(const struct tracking *tracking, struct reading reading) {
    return redcc_fingerprint_equal(redcc_reading_ends(reading), tracking->ends);
}

void redcc_tracking_stable(struct tracking *tracking, struct reading reading, long skipped_calls) {
    const uint64_t stable = tracking->stable_count + 1 + (uint64_t)skipped_calls;
    tracking->stable_count = stable < UINT32_MAX ? (uint32_t)stable : UINT32_MAX;
    if (!tracking->begun)
        return;
    tracking->reading = reading;
    tracking->ends = redcc_reading_ends(reading);
    tracking->version = tracking->begun;
    tracking->skipped = 0;
}
