/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The rows of a bin fit into half of a core's second-level cache while its records are applied. If
 * there are at most 288 bins, a thread can append records directly: for each bin, the cache line
 * that it is writing and its page stay cached. But an iteration that appends to many bins at once
 * would wait until these lines are read. Write combining avoids that, and is also used with more
 * bins.
 */
#include "bins/window.h"

#include <assert.h>

enum {
    LEAST_BITS = 6,
    LEAST_BYTES_OF_SPANS = 4096,
    BINS_A_THREAD = 4,
    RECORDS_A_BIN = 512,
    MOST_BINS = 1 << 16
};

static const uint64_t most_rows = (uint64_t)1 << 40;

struct bins_tuning redcc_bins_tuning = {
    .bin_bytes = 512 * 1024,
    .bin_bits = REDCC_PLACE_BITS,
    .direct_bins = 288,
    .direct_rate = 4,
    .round = INT64_MAX,
    .round_of_spans = 16384,
    .least_budget = (size_t)64 << 20,
    .whole_budget = (size_t)512 << 20,
    .copies_bytes = (size_t)4 << 20,
    .one_thread_bytes = (size_t)48 << 20,
};

size_t redcc_stream_row(const redcc_stream *stream) {
    size_t bytes = 0;
    for (uint32_t array = 0; array < stream->array_count; array++)
        bytes += stream->rows[array];
    return bytes;
}

static uint64_t bins_of(uint64_t rows, uint32_t bits) {
    return ((rows - 1) >> bits) + 1;
}

/* Is there memory to halve a stream's bins, which doubles their number? Each thread has partially
 * filled blocks for all of them. */
static bool affords(const redcc_stream *stream, uint64_t bins, int threads) {
    const double block = (double)REDCC_BLOCK_RECORDS * (stream->record + sizeof(redcc_u16));
    return 4.0 * (double)bins * block * threads < (double)(redcc_bins_tuning.least_budget / 4);
}

/* The smallest number of bits for the rows of a bin. A bin of spans has at least the size of a
 * page. At the end of a span, the processor prefetches the lines that follow, which the thread of
 * the next bin may be writing; but it never prefetches beyond a page. */
static uint32_t least_bits(const redcc_stream *stream) {
    uint32_t bits = LEAST_BITS;
    while (stream->exact == REDCC_STREAM_SPANS &&
           redcc_stream_row(stream) << bits < LEAST_BYTES_OF_SPANS)
        bits++;
    return bits;
}

static uint32_t bits_of(const redcc_stream *stream, uint64_t rows, int threads, double records) {
    const size_t row = redcc_stream_row(stream);
    const uint64_t enough = (uint64_t)threads * BINS_A_THREAD;
    /* least number of records of a bin, from all threads */
    const double each = (double)(threads * RECORDS_A_BIN);
    uint32_t bits = REDCC_PLACE_BITS - stream->tag_bits;
    if (bits > redcc_bins_tuning.bin_bits)
        bits = redcc_bins_tuning.bin_bits;
    while (bits > 0 && row << bits > redcc_bins_tuning.bin_bytes)
        bits--;
    while (bits > least_bits(stream) && bins_of(rows, bits) < enough &&
           (double)bins_of(rows, bits) * each < records &&
           affords(stream, bins_of(rows, bits), threads))
        bits--;
    return bits;
}

struct window redcc_window(const redcc_stream *stream, struct row_range rows, uint64_t margin,
                           int threads, double rate, double iterations) {
    assert(threads >= 1 && rate >= 0 && iterations >= 0);
    if (redcc_rows_empty(rows))
        rows = (struct row_range){0, 0};
    const uint64_t span = (uint64_t)rows.highest - (uint64_t)rows.lowest + 1;
    if (span == 0 || span > most_rows || margin > most_rows)
        return (struct window){0};
    const uint64_t count = span + 2 * margin;
    const uint32_t bits = bits_of(stream, count, threads, rate * iterations);
    if (bins_of(count, bits) > MOST_BINS)
        return (struct window){0};
    const bool combined = bins_of(count, bits) > redcc_bins_tuning.direct_bins ||
                          rate > redcc_bins_tuning.direct_rate;
    return (struct window){.combined = combined,
                           .first = (redcc_int)((uint64_t)rows.lowest - margin),
                           .rows = bins_of(count, bits) << bits,
                           .shift = bits,
                           .bins = (uint32_t)bins_of(count, bits)};
}

struct window redcc_copied_window(struct row_range rows, uint64_t margin) {
    if (redcc_rows_empty(rows))
        rows = (struct row_range){0, 0};
    const uint64_t span = (uint64_t)rows.highest - (uint64_t)rows.lowest + 1;
    return span == 0 || span > most_rows || margin > most_rows
               ? (struct window){0}
               : (struct window){.first = (redcc_int)((uint64_t)rows.lowest - margin),
                                 .rows = span + 2 * margin,
                                 .shift = 63,
                                 .bins = 1};
}
