/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The phases of a binned loop, which binning.h lists. */
#include "bins/binning.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/share.h"

#include <assert.h>
#include <string.h>

enum {
    CHUNK = 16384,  /* number of iterations between two checks whether the round has failed. A
                       smaller number would find a failure before most missing records are counted */
    STRETCHES = 64, /* maximum number of measured stretches per thread */
    STRETCH = 64,   /* maximum number of iterations of a measured stretch */
    MEASURED = 64,  /* in a small share, one iteration in this many is measured */
    LEAST_CHUNK = 512,
    TRIED = 16 /* the first round of a trial has 1 / TRIED of the loop's iterations, and so has the
                  sequential stretch that is compared with it. A shorter stretch would be slowed
                  down by caches that are full of records */
};

/* Factors by which assumed rates exceed measured ones: measured_more after BINS_MEASURE,
 * pushed_more after a round. An assumed rate, and the memory for it, is kept while the measured
 * rate is at most as high as it and at least kept_down_to times as high. */
static const double measured_more = 1.25, pushed_more = 1.0625, kept_down_to = 0.9;

/* A trial's only round is given up, with all its records, if the trial is expected to need more
 * than this fraction of the sequential loop's time until the records are pushed. Applying the
 * records would follow, which took at least an eighth of the time of pushing. */
static const double pushed_most = 0.8;

static uint32_t stream_count(const struct binning *binning) {
    return binning->loop->stream_count;
}

/* The maximum number of iterations of a round. It is limited if a stream has spans: applying a
 * record of a span reads the loop's operands again, and after a short round these are still in the
 * caches. */
static redcc_int most_of_round(const struct binning *binning) {
    redcc_int most = redcc_bins_tuning.round;
    if (redcc_bins_is_whole(binning))
        return INT64_MAX;
    for (uint32_t s = 0; s < stream_count(binning); s++)
        if (binning->loop->streams[s].exact == REDCC_STREAM_SPANS)
            most = redcc_min(most, redcc_bins_tuning.round_of_spans);
    return most;
}

bool redcc_bins_are_late(const struct bins_trial *trial, double trip, double pushed, double now) {
    assert(trial->usual > 0 && pushed > 0);
    const double pushing = (now - trial->pushes) / (pushed < 1 ? pushed : 1);
    return trial->pushes - trial->began + pushing > pushed_most * trial->usual * trip;
}

static bool is_trial(const struct binning *binning) {
    return binning->trial.may_lose != 0;
}

/* ---- each thread's part ---------------------------------------------------------------------- */

static void hand_out(const struct binning *binning, struct binner *binner, redcc_worker *worker,
                     redcc_bins *bins, redcc_int first, redcc_int last) {
    assert(0 <= first && first < last && last <= binning->call->request.trip);
    worker->first = first;
    worker->last = last;
    worker->stride = 1;
    worker->sources = binner->sources;
    for (uint32_t s = 0; s < stream_count(binning); s++)
        bins[s] = binner->holder->buffer[s].push;
}

static void forget_reads(const struct binning *binning, struct binner *binner) {
    memset(binner->sources, 0, binning->loop->loop.source_count * sizeof *binner->sources);
}

static void begin_measure(const struct binning *binning, struct binner *binner) {
    binner->begun = true;
    binner->sample = 0;
    binner->measured = 0;
    forget_reads(binning, binner);
    for (uint32_t s = 0; s < stream_count(binning); s++)
        redcc_buffer_measure(&binner->buffer[s], &binning->loop->streams[s]);
}

/* Hands out the next stretch of iterations; returns false after the last one. The stretches are
 * spread evenly over the thread's share and include its first and last iterations. At most
 * about one iteration in MEASURED is in them (but at least two), because the iterations may be
 * expensive. */
static bool next_stretch(struct binning *binning, struct binner *binner, redcc_worker *worker,
                         redcc_bins *bins) {
    if (!binner->begun)
        begin_measure(binning, binner);
    const redcc_int trip = binning->call->request.trip;
    /* with shares, the sample must not depend on threads */
    const int parts = redcc_in_shares(binning->call) ? 1 : binner->threads;
    if (binner->thread >= parts)
        return false;
    const redcc_int begin = redcc_share(trip, parts, binner->thread);
    const redcc_int end = redcc_share(trip, parts, binner->thread + 1);
    const redcc_int share = end - begin, all = redcc_min(redcc_max(share / MEASURED, 2), share);
    const redcc_int stretches = redcc_min(all, STRETCHES);
    const redcc_int length = redcc_min(redcc_max(all / STRETCHES, 1), STRETCH);
    if (binner->sample == stretches)
        return false;
    const redcc_int first =
        begin + redcc_share(share - length, (int)redcc_max(stretches - 1, 1), binner->sample);
    binner->sample++;
    binner->measured += length;
    hand_out(binning, binner, worker, bins, first, first + length);
    return true;
}

static bool has_failed(const struct binning *binning, const struct binner *binner) {
    for (uint32_t s = 0; s < stream_count(binning); s++)
        if (redcc_buffer_failed(&binner->buffer[s]))
            return true;
    return false;
}

static void begin_push(struct binning *binning, struct binner *binner) {
    binner->begun = true;
    binner->pieces = 0;
    binner->next = binner->last = binner->unseen = binner->pushed = 0;
    forget_reads(binning, binner);
    if (redcc_in_shares(binning->call))
        return; /* redcc_shares_take prepares the copies */
    for (uint32_t s = 0; s < stream_count(binning); s++)
        redcc_buffer_clear(&binner->buffer[s]);
    if (binning->copies.count)
        redcc_private_fill(binning, binner);
}

/* With REDCC_WHOLE, whose only round is all that a trial executes: must the round be given up?
 * Asked from an eighth of the thread's share on, because the first records are slow: their memory
 * is new. */
static bool is_late(const struct binning *binning, const struct binner *binner) {
    const struct bins_trial *it = &binning->trial;
    const double trip = (double)binning->call->request.trip;
    const double pushed = (double)binner->pushed * binner->threads / trip;
    return redcc_bins_is_whole(binning) && is_trial(binning) && it->usual > 0 && pushed >= 0.125 &&
           redcc_bins_are_late(it, trip, pushed, redcc_seconds());
}

/* Hands out the next chunk of the thread's current piece, or of a new piece. */
static bool next_chunk(struct binning *binning, struct binner *binner, redcc_worker *worker,
                       redcc_bins *bins) {
    if (!binner->begun) {
        begin_push(binning, binner);
    } else if (binner->thread == 0 && is_late(binning, binner)) {
        binning->trial.is_late = true;
        atomic_store_explicit(&binning->failed, 1, memory_order_relaxed);
    }
    /* shares are completed, so that the rows found do not depend on threads */
    if (binner->unseen >= CHUNK && !redcc_in_shares(binning->call) && has_failed(binning, binner))
        atomic_store_explicit(&binning->failed, 1, memory_order_relaxed);
    if (atomic_load_explicit(&binning->failed, memory_order_relaxed) ||
        (binner->next == binner->last && !redcc_pieces_take(binning, binner))) {
        for (uint32_t s = 0; s < stream_count(binning); s++)
            redcc_buffer_finish(&binner->buffer[s]);
        return false;
    }
    const redcc_int first = binner->next, left = binner->last - first;
    binner->next += left < CHUNK + LEAST_CHUNK ? left : CHUNK;
    binner->unseen = (binner->unseen < CHUNK ? binner->unseen : 0) + binner->next - first;
    binner->pushed += binner->next - first;
    hand_out(binning, binner, worker, bins, first, binner->next);
    return true;
}

/* ---- between the phases: the first thread decides, while the others wait --------------------- */

/* Undoes the body's effects other than on the arrays. */
static void throw_away(struct binning *binning) {
    atomic_store_explicit(binning->effects.error, binning->round.error_before,
                          memory_order_relaxed);
    atomic_store_explicit(binning->effects.last_claimed, 0, memory_order_relaxed);
}

static enum bins_phase end_with(struct binning *binning, enum reason reason) {
    throw_away(binning);
    binning->reason = reason;
    return BINS_OVER;
}

double redcc_bins_usual(const struct binning *binning) {
    const struct bins_trial *it = &binning->trial;
    return it->stretch > 0 ? it->sequential / (double)it->stretch : 0;
}

/* The seconds that the trial may lose in total. */
static double may_lose(const struct binning *binning) {
    const double most = binning->trial.may_lose;
    const double whole = redcc_bins_usual(binning) * (double)binning->call->request.trip;
    return most < 0 && most >= -1 ? -most * whole : most;
}

/* The seconds that the trial has lost so far. */
static double lost_so_far(const struct binning *binning) {
    const struct bins_trial *it = &binning->trial;
    const redcc_int binned = binning->round.begin - it->stretch;
    const double seconds = redcc_seconds() - it->began - it->sequential;
    return seconds - redcc_bins_usual(binning) * (double)binned;
}

/* The number of iterations of a trial's next round: usually the number of iterations done so far.
 * It is smaller if the trial, at the same loss per iteration, would exceed the time that it may
 * lose, but at least trip / TRIED. */
static redcc_int tried_next(const struct binning *binning) {
    const redcc_int trip = binning->call->request.trip, begin = binning->round.begin;
    const redcc_int least = trip / TRIED + 1;
    if (begin == 0)
        return least;
    const double lost = lost_so_far(binning), left = may_lose(binning) - lost;
    const double each = lost / (double)(begin - binning->trial.stretch);
    return each * (double)begin <= left ? begin : redcc_max((redcc_int)(left / each), least);
}

/* Divides the remaining iterations into rounds of about equal size, and begins the next round. In a
 * trial, that round may be shorter. Memory is allocated for a full round; a shorter round writes
 * only a part of it. */
static enum bins_phase begin_round(struct binning *binning) {
    struct round *round = &binning->round;
    const redcc_int trip = binning->call->request.trip, left = trip - round->begin;
    const redcc_int rounds = (left - 1) / round->most + 1, even = (left - 1) / rounds + 1;
    const redcc_int tried = is_trial(binning) ? tried_next(binning) : trip;
    assert(left > 0 && round->most > 0);
    if (redcc_bins_is_whole(binning) && round->most < trip)
        return end_with(binning, REASON_NO_MEMORY);
    const bool in_part = !redcc_bins_is_whole(binning) && tried < even;
    round->end = round->begin + (in_part ? tried : even);
    round->error_before = atomic_load_explicit(binning->effects.error, memory_order_relaxed);
    atomic_store_explicit(&binning->failed, 0, memory_order_relaxed);
    atomic_store_explicit(&binning->next_bin, 0, memory_order_relaxed);
    redcc_pieces_cut(binning);
    binning->trial.pushes = redcc_bins_is_whole(binning) ? redcc_seconds() : 0;
    return BINS_PUSH;
}

static enum bins_phase lay_out(struct binning *binning) {
    const enum reason reason = redcc_bins_lay_out(binning);
    return reason == REASON_NONE ? begin_round(binning) : end_with(binning, reason);
}

static enum bins_phase after_start(struct binning *binning) {
    /* the check of REDCC_BINS_CHECKED, before any pushing, counts as part of the trial */
    const bool checked = binning->loop->loop.flags & REDCC_BINS_CHECKED;
    binning->trial.began = checked ? binning->call->entered : redcc_seconds();
    for (uint32_t s = 0; s < stream_count(binning); s++)
        if (binning->stream[s].rate == 0)
            return BINS_MEASURE;
    return lay_out(binning);
}

static enum bins_phase after_measure(struct binning *binning) {
    const double never = 1.0 / 1024;
    throw_away(binning);
    for (uint32_t s = 0; s < stream_count(binning); s++) {
        struct binned_stream *it = &binning->stream[s];
        it->rate = never;
        for (int t = 0; t < binning->call->threads; t++) {
            const struct binner *binner = binning->binner[t];
            const struct redcc_bin_buffer *buffer = &binner->buffer[s];
            if (binner->measured == 0)
                continue;
            const double rate =
                measured_more * (double)buffer->outside_count / (double)binner->measured;
            it->rate = rate > it->rate ? rate : it->rate;
            it->rows = redcc_rows_union(it->rows, buffer->outside);
        }
    }
    return lay_out(binning);
}

/* Called if records are missing: the round is executed again. If a row was outside, the bins get
 * more rows; if memory was exhausted, the round gets fewer iterations or, with REDCC_WHOLE, more
 * memory. */
static enum bins_phase push_again(struct binning *binning) {
    struct round *round = &binning->round;
    bool exhausted = false;
    for (uint32_t s = 0; s < stream_count(binning); s++) {
        struct binned_stream *it = &binning->stream[s];
        bool doubled = false;
        for (int t = 0; t < redcc_bins_holders(binning); t++) {
            const struct redcc_bin_buffer *buffer = &binning->binner[t]->buffer[s];
            it->rows = redcc_rows_union(it->rows, buffer->outside);
            doubled |= buffer->exhausted;
        }
        it->rate *= doubled ? 2 : 1;
        exhausted |= doubled;
    }
    const redcc_int count = round->end - round->begin;
    if (exhausted && !redcc_bins_is_whole(binning)) {
        round->most = count > 1 ? count / 2 : 1;
        round->shortened = true;
    } else
        round->failures++;
    throw_away(binning);
    return lay_out(binning);
}

/* Updates what is known of the streams after a round. */
static void learn(struct binning *binning) {
    for (uint32_t s = 0; s < stream_count(binning); s++) {
        struct binned_stream *it = &binning->stream[s];
        double most = 0;
        for (int t = 0; t < binning->call->threads; t++) {
            const struct bins_share *share = &binning->binner[t]->share;
            const redcc_int iterations = share->end - share->begin;
            const double rate =
                iterations ? (double)redcc_pieces_records(binning, t, s) / (double)iterations : 0;
            most = rate > most ? rate : most;
        }
        if (most > it->rate || most < kept_down_to * it->rate)
            it->rate = most > 0 ? pushed_more * most : it->rate;
    }
}

/* Called if the guard forbids private copies. Executes the round again, with copies that have no
 * margin or, if these failed as well, with records (which shares cannot have). */
static enum bins_phase push_precisely(struct binning *binning, enum reason reason) {
    struct private_copies *copies = &binning->copies;
    copies->are_denied = copies->are_tight;
    copies->are_tight = true;
    for (uint32_t s = 0; s < stream_count(binning); s++) {
        struct binned_stream *it = &binning->stream[s];
        it->rows = redcc_rows_union(it->rows, redcc_private_rows(binning, s));
        it->cut_for = 0;
    }
    if (copies->are_denied && redcc_in_shares(binning->call))
        return end_with(binning, reason);
    throw_away(binning);
    return lay_out(binning);
}

static enum bins_phase after_push(struct binning *binning) {
    if (binning->trial.is_late)
        return end_with(binning, REASON_SERIAL_FASTER);
    for (int t = 0; t < redcc_bins_holders(binning); t++)
        if (has_failed(binning, binning->binner[t]))
            return push_again(binning);
    const enum reason reason = redcc_bins_guard(binning);
    if (reason != REASON_NONE)
        return binning->copies.count ? push_precisely(binning, reason) : end_with(binning, reason);
    if (binning->copies.count)
        for (uint32_t s = 0; s < stream_count(binning); s++)
            binning->stream[s].changed = redcc_private_rows(binning, s);
    else
        learn(binning);
    if (binning->witness.tell)
        redcc_bins_tell_written(binning);
    return BINS_APPLY;
}

/* If at most three quarters of the bins lie between the first and the last used bin, lets the next
 * execution cut a window of only these rows. */
static void trim(struct binning *binning) {
    for (uint32_t s = 0; !binning->copies.count && s < stream_count(binning); s++) {
        struct binned_stream *it = &binning->stream[s];
        const struct window window = it->window;
        const struct used_bins used = redcc_used_bins(binning, s);
        if (used.end == 0 || used.end - used.first > window.bins / 4 * 3)
            continue;
        it->cut_for = 0;
        it->rows = (struct row_range){window.first + ((redcc_int)used.first << window.shift),
                                      window.first + ((redcc_int)used.end << window.shift) - 1};
    }
}

/* Makes rounds longer again, because the iterations with many records may be over. */
static enum bins_phase lengthen(struct binning *binning) {
    struct round *round = &binning->round;
    const redcc_int most = most_of_round(binning);
    round->most = round->most < most / 2 ? 2 * round->most : most;
    round->shortened = round->most < binning->call->request.trip - round->begin;
    return lay_out(binning);
}

/* Begins a stretch, which is executed sequentially and has the same number of iterations as the
 * first round. Comparing the two times shows what that round has gained, even if the loop's speed
 * differs from that of earlier executions. */
static enum bins_phase begin_stretch(struct binning *binning) {
    struct round *round = &binning->round;
    const redcc_int left = binning->call->request.trip - round->begin;
    binning->trial.stretch = left < round->begin ? left : round->begin;
    round->end = round->begin + binning->trial.stretch;
    binning->trial.sequential = redcc_seconds();
    return BINS_STRETCH;
}

/* Continues with the next round, if there is one. */
static enum bins_phase go_on(struct binning *binning) {
    struct round *round = &binning->round;
    round->begin = round->end;
    round->failures = 0;
    if (round->begin == binning->call->request.trip)
        return BINS_OVER;
    if (is_trial(binning) && binning->trial.stretch == 0)
        return begin_stretch(binning);
    if (!is_trial(binning) || lost_so_far(binning) <= may_lose(binning))
        return round->shortened ? lengthen(binning) : begin_round(binning);
    binning->reason = REASON_SERIAL_FASTER;
    return BINS_OVER;
}

static enum bins_phase after_stretch(struct binning *binning) {
    binning->trial.sequential = redcc_seconds() - binning->trial.sequential;
    return go_on(binning);
}

static enum bins_phase after_apply(struct binning *binning) {
    binning->rounds++;
    binning->copies.are_neutral = redcc_in_shares(binning->call);
    const enum bins_phase next = go_on(binning);
    if (next == BINS_OVER && binning->reason == REASON_NONE && binning->rounds == 1)
        trim(binning);
    return next;
}

static enum bins_phase (*const then[])(struct binning *) = {[BINS_START] = after_start,
                                                            [BINS_MEASURE] = after_measure,
                                                            [BINS_PUSH] = after_push,
                                                            [BINS_APPLY] = after_apply,
                                                            [BINS_STRETCH] = after_stretch};
_Static_assert(sizeof then / sizeof *then == BINS_OVER, "what follows each phase");

/* Waits at a barrier. The first thread then allocates memory and decides how to continue. */
static void meet(struct binning *binning, struct binner *binner) {
    redcc_barrier_wait(binning->barrier, binner->threads);
    if (binner->thread == 0)
        binning->phase = then[binner->phase](binning);
    redcc_barrier_wait(binning->barrier, binner->threads);
    binner->phase = binning->phase;
    binner->begun = false;
}

bool redcc_bins_step(struct binning *binning, struct binner *binner, redcc_worker *worker,
                     redcc_bins *bins, const void *operands) {
    for (; binner->phase != BINS_OVER; meet(binning, binner)) {
        if (binner->phase == BINS_STRETCH && !binner->begun) {
            binner->begun = true;
            return false;
        }
        if (binner->phase == BINS_APPLY && binning->copies.count)
            redcc_private_merge(binning, binner);
        else if (binner->phase == BINS_APPLY)
            redcc_bins_apply(binning, binner, operands);
        const bool handed = binner->phase == BINS_MEASURE
                                ? next_stretch(binning, binner, worker, bins)
                            : binner->phase == BINS_PUSH ? next_chunk(binning, binner, worker, bins)
                                                         : false;
        for (uint32_t s = 0; handed && s < stream_count(binning); s++)
            bins[s].operands = operands;
        if (handed)
            return true;
    }
    return false;
}

/* ---- the beginning --------------------------------------------------------------------------- */

void redcc_bins_begin(struct binning *binning, double may_lose, double usual,
                      struct written_witness witness) {
    binning->phase = BINS_START;
    binning->trial = (struct bins_trial){.may_lose = may_lose, .usual = usual};
    binning->witness = witness;
    binning->round = (struct round){.most = binning->loop ? most_of_round(binning) : 1};
    binning->reason = REASON_NONE;
    binning->rounds = 0;
    binning->bytes = 0;
    if (binning->loop)
        binning->stream =
            binning->known + (redcc_in_shares(binning->call) ? stream_count(binning) : 0);
}
