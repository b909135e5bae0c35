/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "vouch.h"

#include "loop.h"
#include "settings.h"
#include "watch.h"
#include "written_pages.h"

/* To protect a page takes 0.1 microseconds, a write to it then 1.3 once; to compare it, 0.12 (4096
 * bytes at 35 GB/s). To look whether a source may be watched takes some 250, whatever its size. */
enum {
    A_PAGE = 12,             /* comparisons of it that cost as much as to watch it in vain */
    A_SOURCE = 2048,         /* pages that are compared meanwhile */
    COMPARED_AT_ONCE = 4096, /* bytes, of these measures */
    SETBACKS_MOST = 16,
    LEAST = 256 * 1024 /* bytes; to compare fewer costs little more than to ask */
};

static struct reading reading_of(const struct execution *execution, uint32_t source) {
    return redcc_reading_of(execution->request.loop, execution->request.known, execution->sources,
                            source);
}

/* So many comparisons have cost as much as to watch the pages may cost in vain: who begins then
 * loses at most as much again (the rule of ski rental). */
static uint32_t patience(struct range pages) {
    return (uint32_t)(A_PAGE + A_SOURCE / (redcc_range_bytes(pages) / COMPARED_AT_ONCE));
}

/* It was in vain: the next time one waits twice as long. */
static void set_back(struct loop_state *state, struct vouch *vouch) {
    vouch->calm = 0;
    if (state->setbacks < SETBACKS_MOST)
        state->setbacks++;
}

/* The source was written to: was it worth it? */
static void end_watch(struct loop_state *state, struct vouch *vouch, struct range pages) {
    if (vouch->spared >= patience(pages)) {
        vouch->calm = 0;
        state->setbacks = 0;
    } else
        set_back(state, vouch);
    vouch->version = 0;
}

/* The version from which on the pages are watched, where they are by now; 0: not yet. Where they
 * cannot be, it has cost something to find that out. */
static uint64_t begin_watch(struct loop_state *state, struct vouch *vouch, struct range pages) {
    if (redcc_range_bytes(pages) < LEAST)
        return 0;
    const uint64_t shared = redcc_watch_share(pages);
    if (shared || vouch->calm < (uint64_t)patience(pages) << state->setbacks)
        return shared;
    const uint64_t version = redcc_watch_begin(pages);
    if (!version)
        set_back(state, vouch);
    return version;
}

static void ask(struct loop_state *state, struct vouch *vouch, struct reading reading) {
    const struct range pages = redcc_whole_pages(reading.range);
    if (vouch->version && redcc_readings_equal(vouch->reading, reading)) {
        const enum watch_answer answer = redcc_watch_ask(pages, vouch->version);
        vouch->stands = answer == WATCH_UNTOUCHED;
        vouch->spared += vouch->stands;
        if (answer != WATCH_TOUCHED)
            return;
        end_watch(state, vouch, pages);
    }
    vouch->begun = begin_watch(state, vouch, pages);
}

void redcc_ask_watch(struct execution *execution) {
    struct plan *plan = execution->candidate;
    const redcc_loop *loop = execution->request.loop;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        struct vouch *vouch = &plan->source[s].vouch;
        vouch->stands = false;
        vouch->begun = 0;
        if (loop->sources[s].is_subscript && redcc_settings()->watch)
            ask(execution->state, vouch, reading_of(execution, s));
    }
}

bool redcc_vouched_unchanged(const struct execution *execution, uint32_t source) {
    return redcc_fingerprint_equal(redcc_reading_ends(reading_of(execution, source)),
                                   execution->candidate->source[source].vouch.ends);
}

void redcc_note_unchanged(struct execution *execution, uint32_t source) {
    struct vouch *vouch = &execution->candidate->source[source].vouch;
    const uint64_t calm = vouch->calm + 1 + (uint64_t)execution->rested;
    vouch->calm = calm < UINT32_MAX ? (uint32_t)calm : UINT32_MAX;
    if (!vouch->begun)
        return;
    vouch->reading = reading_of(execution, source);
    vouch->ends = redcc_reading_ends(vouch->reading);
    vouch->version = vouch->begun;
    vouch->spared = 0;
}

uint32_t redcc_vouched_sources(const struct execution *execution) {
    uint32_t count = 0;
    for (uint32_t s = 0; s < execution->request.loop->source_count; s++)
        count += execution->plan->source[s].vouch.stands;
    return count;
}
