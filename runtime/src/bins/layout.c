/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Determines the size of rounds. Rounds are as large as memory permits, because a round loads each
 * line of the updated arrays from memory and stores it once. The records of all threads may take
 * 0.6 times the bytes of the arrays plus 64 MiB. If the loop must be one round, they may take 512
 * MiB instead of 64.
 */
#include "bins/shares.h"

#include "base/memory.h"

enum { MARGIN_SHIFT = 6, MARGIN_ROWS = 64, FAILURES_OF_COPIES = 4, MOST_FAILURES = 24 };

/* The number of rows to add at each end of the window. The range of rows may have been found in a
 * part of the iterations, so its outermost rows may be missing. After failures the margin is
 * larger. */
static uint64_t margin_of(const struct binning *binning, struct row_range rows) {
    if (redcc_rows_empty(rows))
        return MARGIN_ROWS;
    const int failures = binning->round.failures;
    const uint64_t span = (uint64_t)rows.highest - (uint64_t)rows.lowest;
    return (span >> MARGIN_SHIFT) * (uint64_t)(1 + failures * failures) + MARGIN_ROWS;
}

static redcc_int left_of(const struct binning *binning) {
    return binning->call->request.trip - binning->round.begin;
}

/* The recorded rows, and some rows before them, so that the window begins with a cache line.
 * Otherwise two threads that apply records of adjacent bins at the same time might write to the
 * same line. */
static struct row_range from_a_line(const struct binning *binning, uint32_t s, uint64_t margin) {
    const redcc_stream *stream = &binning->loop->streams[s];
    struct row_range rows = binning->stream[s].rows;
    uintptr_t first = redcc_row_address(binning, stream, 0, rows.lowest) - margin * stream->rows[0];
    for (int before = 0;
         before < REDCC_CACHE_LINE && rows.lowest >= INT64_MIN + before && !redcc_rows_empty(rows);
         before++)
        if ((first - (uintptr_t)before * stream->rows[0]) % REDCC_CACHE_LINE == 0) {
            rows.lowest = (redcc_int)((uint64_t)rows.lowest - (uint64_t)before);
            break;
        }
    return rows;
}

/* The window of private copies of the rows. A tight window that lacked a row gets a margin. */
static struct window copied_window(const struct binning *binning, struct row_range rows) {
    const bool is_tight = binning->copies.are_tight && binning->round.failures == 0;
    return redcc_copied_window(rows, is_tight ? 0 : margin_of(binning, rows));
}

/* Cuts a window for each stream that has none, or whose expected number of records has changed
 * much. Other windows are kept, and so is their memory. Returns false if the rows are spread too
 * widely. */
static bool cut_windows(struct binning *binning) {
    for (uint32_t s = 0; s < binning->loop->stream_count; s++) {
        const redcc_stream *stream = &binning->loop->streams[s];
        struct binned_stream *it = &binning->stream[s];
        const double records = it->rate * (double)left_of(binning) + 1;
        const int threads = binning->call->threads;
        const bool is_copied = binning->copies.count > 0;
        if (it->cut_for > 0 && records < 4 * it->cut_for && records > it->cut_for / 16 &&
            it->cut_threads == threads && it->is_copied == is_copied)
            continue;
        binning->copies.are_neutral = false;
        it->cut_for = records;
        it->cut_threads = threads;
        it->is_copied = is_copied;
        const uint64_t margin = margin_of(binning, it->rows);
        it->window = is_copied ? copied_window(binning, it->rows)
                               : redcc_window(stream, from_a_line(binning, s, margin), margin,
                                              threads, it->rate, (double)left_of(binning));
        if (it->window.rows == 0)
            return false;
    }
    return true;
}

/* The size in bytes of the recorded rows of all arrays. */
static size_t bytes_of_arrays(const struct binning *binning) {
    size_t bytes = 0;
    for (uint32_t s = 0; s < binning->loop->stream_count; s++) {
        const struct row_range rows = binning->stream[s].rows;
        if (!redcc_rows_empty(rows))
            bytes += ((uint64_t)rows.highest - (uint64_t)rows.lowest + 1) *
                     redcc_stream_row(&binning->loop->streams[s]);
    }
    return bytes;
}

/* Are private copies better than bins? Merging them must not take more work than the updates. */
static bool wants_copies(const struct binning *binning) {
    const int kind = binning->call->parameter;
    double rows = 0, records = 0;
    size_t bytes = 0;
    /* the forms of these loops that update copies add up operands in the blocks of shares */
    const bool adds = binning->loop->is_unordered && binning->loop->loop.flags & REDCC_ORDER_NEEDED;
    if (kind == BINS_RECORDS || adds || binning->copies.are_denied || binning->round.begin > 0 ||
        binning->round.failures >= FAILURES_OF_COPIES)
        return false;
    for (uint32_t s = 0; s < binning->loop->stream_count; s++) {
        const redcc_stream *stream = &binning->loop->streams[s];
        const struct window window = copied_window(binning, binning->stream[s].rows);
        if (!redcc_private_possible(binning, stream) || window.rows == 0)
            return false;
        rows += (double)window.rows;
        bytes += window.rows * redcc_stream_row(stream);
        records += binning->stream[s].rate * (double)left_of(binning);
    }
    if (bytes > redcc_bins_tuning.least_budget / (size_t)binning->call->threads)
        return false;
    return kind == BINS_COPIES || (binning->call->threads > 1 && records > rows &&
                                   bytes <= redcc_bins_tuning.copies_bytes);
}

/* Sets the number of copies. After a failure, makes redcc_bins_lay_out cut the windows again. */
static void choose_kind(struct binning *binning, int copies) {
    for (uint32_t s = 0; binning->round.failures > 0 && s < binning->loop->stream_count; s++)
        binning->stream[s].cut_for = 0;
    binning->copies.count = copies;
}

static bool take_copies(struct binning *binning) {
    bool taken = true;
    for (int t = 0; taken && t < binning->copies.count; t++)
        for (uint32_t s = 0; taken && s < binning->loop->stream_count; s++)
            taken =
                redcc_buffer_shape_copies(&binning->binner[t]->buffer[s],
                                          &binning->loop->streams[s], binning->stream[s].window);
    binning->round.most = left_of(binning);
    return taken;
}

/* ---- records --------------------------------------------------------------------------------- */

/* The number of blocks for a thread that pushes `iterations` iterations of its share, and some
 * stolen pieces. On average the last block of each bin is half full. */
static uint32_t blocks_for(const struct binned_stream *it, double iterations) {
    const double block = REDCC_BLOCK_RECORDS, and_others = 1.25;
    const double most = (double)UINT32_MAX / block - 1; /* record numbers have 32 bits */
    const double blocks = and_others * it->rate * iterations / block + 1.5 * it->window.bins + 2;
    return (uint32_t)(blocks < most ? blocks : most);
}

static double bytes_for(const struct binning *binning, double iterations) {
    double bytes = 0;
    for (uint32_t s = 0; s < binning->loop->stream_count; s++)
        bytes += (double)redcc_buffer_bytes(&binning->loop->streams[s], binning->stream[s].window,
                                            blocks_for(&binning->stream[s], iterations));
    return bytes * binning->call->threads;
}

/* The number of iterations per thread, at most `most`, for which the buffers of all threads
 * together fit in `budget` bytes. Below 1: not even one iteration fits. */
static double share_for(const struct binning *binning, double budget, double most) {
    double low = 0, high = most;
    if (bytes_for(binning, high) <= budget)
        return high;
    for (int halvings = 0; halvings < 40; halvings++) {
        const double middle = (low + high) / 2;
        if (bytes_for(binning, middle) <= budget)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static bool take_blocks(struct binning *binning, double share) {
    for (int t = 0; t < binning->call->threads; t++)
        for (uint32_t s = 0; s < binning->loop->stream_count; s++)
            if (!redcc_buffer_shape(&binning->binner[t]->buffer[s], &binning->loop->streams[s],
                                    binning->stream[s].window,
                                    blocks_for(&binning->stream[s], share)))
                return false;
    return true;
}

static bool take_records(struct binning *binning) {
    const redcc_int left = left_of(binning), most = binning->round.most;
    const double threads = binning->call->threads;
    double wanted = (double)(left < most ? left : most) / threads + 1;
    double budget = 0.6 * (double)bytes_of_arrays(binning) +
                    (double)(redcc_bins_is_whole(binning) ? redcc_bins_tuning.whole_budget
                                                          : redcc_bins_tuning.least_budget);
    for (;; budget /= 2) {
        wanted = share_for(binning, budget, wanted);
        if (wanted < 1)
            return false;
        if (take_blocks(binning, wanted))
            break;
        redcc_bins_drop(binning);
    }
    const redcc_int round = (redcc_int)wanted * binning->call->threads;
    binning->round.most = round < most ? round : most;
    return true;
}

/* ---- the layout ----------------------------------------------------------------------------- */

static size_t bytes_held(const struct binning *binning) {
    size_t bytes = 0;
    for (int t = 0; t < redcc_bins_holders(binning); t++)
        for (uint32_t s = 0; s < binning->loop->stream_count; s++)
            bytes += redcc_memory_size(binning->binner[t]->buffer[s].memory);
    return bytes;
}

/* Is binning worthwhile with this number of threads? With a single thread, only if a variant of it
 * was named (BINS_RECORDS or BINS_COPIES), or if the arrays exceed the caches. */
static bool is_for_several(const struct binning *binning) {
    return binning->call->threads > 1 || binning->call->parameter != BINS_EITHER ||
           bytes_of_arrays(binning) >= redcc_bins_tuning.one_thread_bytes;
}

static void note_bytes(struct binning *binning) {
    const size_t bytes = bytes_held(binning);
    binning->bytes = bytes > binning->bytes ? bytes : binning->bytes;
}

static enum reason lay_out_shares(struct binning *binning) {
    const struct call *call = binning->call;
    const int shares = redcc_bins_shares(binning, call->request.trip, call->memory_limit);
    if (shares < 2)
        return REASON_UNATTRACTIVE;
    for (uint32_t s = 0; s < binning->loop->stream_count; s++)
        if (!redcc_private_possible(binning, &binning->loop->streams[s]))
            return REASON_NO_COPIES;
    const bool are_neutral = binning->copies.are_neutral && binning->copies.count == shares;
    choose_kind(binning, shares);
    if (!cut_windows(binning))
        return REASON_SPREAD;
    const bool taken = take_copies(binning);
    binning->copies.need_filling = !are_neutral || !binning->copies.are_neutral;
    binning->copies.are_neutral = false;
    note_bytes(binning);
    if (!taken)
        redcc_bins_drop(binning);
    return taken ? REASON_NONE : REASON_NO_MEMORY;
}

enum reason redcc_bins_lay_out(struct binning *binning) {
    if (binning->round.failures > MOST_FAILURES)
        return REASON_SPREAD;
    if (redcc_in_shares(binning->call))
        return lay_out_shares(binning);
    binning->copies.are_neutral = false;
    choose_kind(binning, wants_copies(binning) ? binning->call->threads : 0);
    if (!cut_windows(binning))
        return REASON_SPREAD;
    if (!is_for_several(binning))
        return REASON_ONE_THREAD;
    bool taken = binning->copies.count && take_copies(binning);
    if (!taken && binning->copies.count) {
        redcc_bins_drop(binning);
        choose_kind(binning, 0);
        if (!cut_windows(binning))
            return REASON_SPREAD;
    }
    taken = taken || take_records(binning);
    if (!taken)
        redcc_bins_drop(binning);
    note_bytes(binning);
    return taken ? REASON_NONE : REASON_NO_MEMORY;
}
