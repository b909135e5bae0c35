/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "beginning.h"

#include "base/clock.h"
#include "base/forked.h"
#include "base/region.h"
#include "base/share.h"
#include "base/team.h"
#include "learn/constants.h"
#include "library.h"
#include "loop.h"
#include "plan/schedule.h"
#include "settings.h"

#include <assert.h>
#include <math.h>
#include <string.h>

enum {
    LEAST_TRIP = 64,
    PART = 64,      /* the first trip / PART iterations are timed */
    PIECES = 4,     /* number of pieces that are timed separately */
    MOST_ARRAYS = 8 /* no translated loop has more arrays */
};

/* A time in seconds. If the sequential loop takes longer, the iterations that follow the first ones
 * may repay the extra cost of a first parallel execution: a sample, starting threads, and page
 * faults. */
static const double long_enough = 4 * LEARN_SAMPLE / LEARN_SHARE;

/* The state of the calling thread while it executes iterations in order. */
struct in_order {
    redcc_worker worker; /* must be first: the functions below convert a pointer to it */
    redcc_call call;
    redcc_calls calls;
    redcc_owner owner[MOST_ARRAYS]; /* unused, because no owner is checked */
    redcc_iterations run;
    redcc_int next, end, trip;
};

static int hand_out_none(redcc_worker *worker) {
    (void)worker;
    return 0;
}

static int hand_out_no_bins(redcc_worker *worker, redcc_bins *bins, const void *operands) {
    (void)worker, (void)bins, (void)operands;
    return 0;
}

static int hand_out(redcc_worker *worker) {
    struct in_order *it = (struct in_order *)(void *)worker;
    const redcc_int count = redcc_min(it->end - it->next, REDCC_RUN_MOST);
    it->run = (redcc_iterations){0, 2 * (redcc_u32)count};
    worker->origin = it->next;
    worker->run = &it->run;
    worker->run_end = &it->run + 1;
    it->next += count;
    return count > 0;
}

static int claims_last(redcc_worker *worker) {
    const struct in_order *it = (const struct in_order *)(const void *)worker;
    return it->end == it->trip;
}

static void execute(redcc_site *site, const redcc_attempt *attempt, redcc_member *member,
                    const void *context, redcc_int begin, redcc_int end) {
    struct in_order it = {.call = {.loop = &site->binned.loop, .trip = attempt->trip, .threads = 1},
                          .calls = redcc_library,
                          .next = begin,
                          .end = end,
                          .trip = attempt->trip};
    assert(site->binned.loop.array_count <= MOST_ARRAYS);
    it.call.calls = &it.calls;
    it.calls.inspect = hand_out_none;
    it.calls.bins_next = hand_out_no_bins;
    it.calls.next = hand_out;
    it.calls.claims_last = claims_last;
    it.worker = (redcc_worker){.call = &it.call, .base = attempt->bases, .owner = it.owner};
    member(&it.worker, attempt, context);
}

void redcc_end_in_order(redcc_site *site, const redcc_attempt *attempt, redcc_member *member,
                        const void *context, redcc_int from) {
    assert(0 <= from && from <= attempt->trip);
    execute(site, attempt, member, context, from, attempt->trip);
}

/* Is this the loop's first execution, and may `auto` decide about it? False with an order other
 * than serial, because with the order `fixed` sums depend on which iterations are executed
 * together. */
static bool is_due(redcc_loop *loop, const redcc_attempt *attempt, int threads) {
    if (!(loop->flags & REDCC_BEGINS) || attempt->trip < LEAST_TRIP || threads < 2 ||
        loop->key_count > BEGINNING_KEYS || __atomic_load_n(&loop->state, __ATOMIC_ACQUIRE))
        return false;
    const struct settings *settings = redcc_settings_for(loop);
    return redcc_order_of(loop, settings) == REDCC_ORDER_SERIAL && !settings->method &&
           !settings->compensated && !settings->validate && !redcc_within &&
           !redcc_region_is_nested() && !redcc_is_forked();
}

static void leave_rest(struct beginning *it, const redcc_loop *loop, const redcc_attempt *attempt) {
    it->rest = *attempt;
    it->rest.trip -= it->done;
    it->rest.first += it->done;
    memcpy(it->key, attempt->key, loop->key_count * sizeof *it->key);
    it->key[0] = (redcc_word)it->rest.first;
    it->rest.key = it->key;
}

/* Executes the first `count` iterations in pieces, and times each piece. Returns the seconds that
 * `count` iterations take at the speed of the fastest piece, because the first piece is slowed by
 * page faults and cache misses. */
static double time_first(redcc_site *site, const redcc_attempt *attempt, redcc_member *member,
                         const void *context, redcc_int count) {
    const redcc_int pieces = redcc_min(PIECES, count);
    double least = HUGE_VAL;
    redcc_int begin = 0;
    for (redcc_int piece = 1; piece <= pieces; piece++) {
        const redcc_int end = count * piece / pieces;
        const double began = redcc_seconds();
        execute(site, attempt, member, context, begin, end);
        const double each = (redcc_seconds() - began) / (double)(end - begin);
        least = each < least ? each : least;
        begin = end;
    }
    return least * (double)count;
}

void redcc_begin_in_order(struct beginning *beginning, redcc_site *site,
                          const redcc_attempt *attempt, redcc_member *member, const void *context,
                          int threads) {
    redcc_loop *loop = &site->binned.loop;
    beginning->done = 0;
    if (!is_due(loop, attempt, threads))
        return;
    const double began = redcc_seconds();
    beginning->done = attempt->trip / PART;
    const double later = time_first(site, attempt, member, context, beginning->done);
    if (later * (double)PART >= long_enough) {
        leave_rest(beginning, loop, attempt);
        redcc_note_begun(loop, beginning->rest.trip, beginning->done, later);
        return;
    }
    redcc_end_in_order(site, attempt, member, context, beginning->done);
    redcc_note_done(loop, attempt->trip, attempt->known, redcc_seconds() - began);
    beginning->done = attempt->trip;
}
