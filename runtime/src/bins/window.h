/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Divides the rows of a stream's arrays into bins. */
#ifndef REDCC_WINDOW_H
#define REDCC_WINDOW_H

#include "redcc/bins.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Recorded rows, [lowest, highest]; none if highest < lowest. */
struct row_range {
    redcc_int lowest;
    redcc_int highest;
};

static const struct row_range redcc_no_rows = {INT64_MAX, INT64_MIN};

static inline bool redcc_rows_empty(struct row_range rows) {
    return rows.highest < rows.lowest;
}

/** The smallest range that contains both. */
static inline struct row_range redcc_rows_union(struct row_range a, struct row_range b) {
    return (struct row_range){a.lowest < b.lowest ? a.lowest : b.lowest,
                              a.highest > b.highest ? a.highest : b.highest};
}

/** Consecutive rows, bin after bin. */
struct window {
    redcc_int first; /* row of the first bin's place 0 */
    uint64_t rows;   /* 0: there is no window */
    uint32_t shift;  /* a bin has 2 ^ shift rows */
    uint32_t bins;
    bool combined; /* records are pushed by write combining */
};

/** Parameters that tests may change. */
struct bins_tuning {
    size_t bin_bytes;         /* maximum bytes of the rows of a bin */
    uint32_t bin_bits;        /* a bin has at most 2 ^ bin_bits rows */
    uint32_t direct_bins;     /* with more bins than this, records are pushed by write combining */
    double direct_rate;       /* likewise if an iteration has more records than this */
    redcc_int round;          /* maximum iterations of a round */
    redcc_int round_of_spans; /* the same if a stream has spans */
    size_t least_budget;      /* bytes of records, for arrays of any size */
    size_t whole_budget;      /* the same if the loop must be one round */
    size_t copies_bytes;      /* maximum bytes of arrays that have private copies */
    size_t one_thread_bytes;  /* minimum bytes of arrays for which one thread uses bins */
    double trial;             /* if binning is named: the seconds it may lose (redcc_bins_begin) */
};

extern struct bins_tuning redcc_bins_tuning;

/** Bytes of the rows of all arrays of a stream, at one subscript. */
size_t redcc_stream_row(const redcc_stream *stream);

/** The window of `rows`, with `margin` more rows on either side. It has enough bins for `threads`
 * threads, but a bin gets at least some hundreds of records per thread, of `rate` * `iterations` in
 * all. A window without rows: the range is too large. */
struct window redcc_window(const redcc_stream *stream, struct row_range rows, uint64_t margin,
                           int threads, double rate, double iterations);

/** The same for private copies: all rows are in one bin. */
struct window redcc_copied_window(struct row_range rows, uint64_t margin);

/** The rows of a window. */
static inline struct row_range redcc_window_rows(struct window window) {
    return window.rows == 0
               ? redcc_no_rows
               : (struct row_range){window.first, window.first + (redcc_int)(window.rows - 1)};
}

#endif
