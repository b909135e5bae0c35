/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The guard of a round. It is executed when all records of the round exist, but nothing is written
 * yet. So the addresses that the round has read and will write are known exactly. Writes of earlier
 * rounds precede these reads in the sequential loop as well.
 */
#include "bins/binning.h"

#include <assert.h>

#include "base/aliases.h"
#include "base/memory.h"

static uint32_t place_of(const redcc_stream *stream, redcc_u16 place) {
    return REDCC_PLACE_ROW(place, stream->tag_bits);
}

static bool is_used(const struct binning *binning, uint32_t s, uint32_t bin) {
    for (int t = 0; t < binning->call->threads; t++)
        if (redcc_bin_is_used(&binning->binner[t]->buffer[s], bin))
            return true;
    return false;
}

struct used_bins redcc_used_bins(const struct binning *binning, uint32_t s) {
    assert(s < binning->loop->stream_count);
    struct used_bins used = {0, 0};
    for (uint32_t bin = 0; bin < binning->stream[s].window.bins; bin++)
        if (is_used(binning, s, bin)) {
            used.first = used.end == 0 ? bin : used.first;
            used.end = bin + 1;
        }
    return used;
}

/* The lowest and the highest place in a bin, over all threads' records. */
static struct row_range places_in(const struct binning *binning, uint32_t s, uint32_t bin) {
    struct row_range found = redcc_no_rows;
    for (int t = 0; t < binning->call->threads; t++) {
        const struct redcc_bin_buffer *buffer = &binning->binner[t]->buffer[s];
        struct records records;
        for (struct stretch left = redcc_bin_all(buffer, bin);
             redcc_bin_records(buffer, &left, &records);)
            for (size_t k = 0; k < records.count; k++) {
                const redcc_int row = place_of(buffer->stream, records.place[k]);
                found = redcc_rows_union(found, (struct row_range){row, row});
            }
    }
    return found;
}

static struct row_range reached_rows(const struct binning *binning, uint32_t s) {
    struct row_range rows = redcc_no_rows;
    for (int t = 0; t < binning->call->threads; t++)
        rows = redcc_rows_union(rows, binning->binner[t]->buffer[s].reached);
    return rows;
}

/* Which rows count as updated by the round. */
enum updated {
    UPDATED_BINS, /* all rows of the used bins */
    UPDATED_ROWS, /* the rows from the first to the last record */
    STORED_ROWS   /* the same or, in private copies, only the rows that have changed in the end */
};

/* The range of the rows that the round has updated. The rows of a private copy that are unchanged
 * in the end do not suffice: after `h[r] ^= 2` was executed twice, h[r] is unchanged, but an
 * iteration in between may have read it. So all rows that copies have may be updated. */
static struct row_range updated_rows(const struct binning *binning, uint32_t s,
                                     enum updated which) {
    const struct window window = binning->stream[s].window;
    if (binning->copies.count)
        return which == STORED_ROWS ? binning->stream[s].changed : redcc_window_rows(window);
    if (binning->loop->streams[s].exact == REDCC_STREAM_SPANS)
        return reached_rows(binning, s);
    const struct used_bins used = redcc_used_bins(binning, s);
    if (used.end == 0)
        return redcc_no_rows;
    const redcc_int low = window.first + ((redcc_int)used.first << window.shift);
    const redcc_int end = window.first + ((redcc_int)used.end << window.shift);
    if (which == UPDATED_BINS)
        return (struct row_range){low, end - 1};
    return (struct row_range){low + places_in(binning, s, used.first).lowest,
                              end - ((redcc_int)1 << window.shift) +
                                  places_in(binning, s, used.end - 1).highest};
}

/* The range of an array of the loop that the round has updated. */
static struct range updated_of(const struct binning *binning, uint32_t array, enum updated which) {
    struct range range = redcc_nowhere;
    for (uint32_t s = 0; s < binning->loop->stream_count; s++) {
        const redcc_stream *stream = &binning->loop->streams[s];
        for (uint32_t a = 0; a < stream->array_count; a++) {
            if (stream->arrays[a] != array)
                continue;
            const struct row_range rows = updated_rows(binning, s, which);
            if (!redcc_rows_empty(rows))
                range = (struct range){redcc_row_address(binning, stream, a, rows.lowest),
                                       redcc_row_address(binning, stream, a, rows.highest + 1)};
        }
    }
    return range;
}

/* Sets read[source_count] to the address ranges that the loop is known to read, extended by the
 * reads that were recorded in the round. */
static void find_read(const struct binning *binning, struct range *read) {
    for (uint32_t source = 0; source < binning->loop->loop.source_count; source++) {
        read[source] = redcc_range_of(binning->call->request.known[source]);
        for (int t = 0; t < binning->call->threads; t++)
            read[source] = redcc_range_union(read[source],
                                             redcc_range_of(binning->binner[t]->sources[source]));
    }
}

static bool are_disjoint(const struct range *written, uint32_t count) {
    for (uint32_t a = 0; a < count; a++)
        for (uint32_t b = 0; b < a; b++)
            if (redcc_ranges_overlap(written[a], written[b]))
                return false;
    return true;
}

static enum reason ask(struct binning *binning, enum updated which, struct range *written,
                       struct range *read) {
    const redcc_loop *loop = &binning->loop->loop;
    for (uint32_t array = 0; array < loop->array_count; array++)
        written[array] = updated_of(binning, array, which);
    if (!redcc_ranges_are_disjoint(loop, read, written, loop->array_count, &binning->overlap))
        return REASON_OVERLAP;
    if (!are_disjoint(written, loop->array_count))
        return REASON_OUT_OF_STEP;
    const struct touches touches = {written, loop->array_count, read, loop->source_count, loop};
    return redcc_may_be_aliased(touches) ? REASON_TWO_ADDRESSES : REASON_NONE;
}

enum reason redcc_bins_guard(struct binning *binning) {
    const redcc_loop *loop = &binning->loop->loop;
    struct range *written = redcc_memory_alloc(loop->array_count * sizeof *written);
    struct range *read = redcc_memory_alloc(loop->source_count * sizeof *read);
    enum reason reason = REASON_NO_MEMORY;
    if (written && read) {
        find_read(binning, read);
        reason = ask(binning, UPDATED_BINS, written, read);
        if (reason != REASON_NONE && !binning->copies.count)
            reason = ask(binning, UPDATED_ROWS, written, read);
    }
    redcc_memory_free(written);
    redcc_memory_free(read);
    return reason;
}

void redcc_bins_tell_written(const struct binning *binning) {
    const redcc_loop *loop = &binning->loop->loop;
    for (uint32_t array = 0; array < loop->array_count; array++)
        binning->witness.tell(binning->witness.whom, array,
                              updated_of(binning, array, STORED_ROWS));
}
