/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Divides the rows of a stream's arrays into bins. */
#ifndef REDCC_WINDOW_H
#define REDCC_WINDOW_H

#include "redcc/bins.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** A range of rows from `lowest` to `highest`; empty if highest < lowest. */
struct row_range {
    redcc_int lowest;
    redcc_int highest;
};

static const struct row_range redcc_no_rows = {INT64_MAX, INT64_MIN};

static inline bool redcc_rows_empty(struct row_range rows) {
    return rows.highest < rows.lowest;
}

/** The smallest range that contains both ranges. */
static inline struct row_range redcc_rows_union(struct row_range a, struct row_range b) {
    return (struct row_range){a.lowest < b.lowest ? a.lowest : b.lowest,
                              a.highest > b.highest ? a.highest : b.highest};
}

/** A window: consecutive rows, divided into bins. */
struct window {
    redcc_int first; /* the row at place 0 of the first bin */
    uint64_t rows;   /* number of rows; 0: there is no window */
    uint32_t shift;  /* a bin has 2^shift rows */
    uint32_t bins;
    bool combined; /* records are pushed by write combining */
};

/** Parameters, which tests may change. */
struct bins_tuning {
    size_t bin_bytes;     /* maximum size of the rows of a bin in bytes */
    uint32_t bin_bits;    /* a bin has at most 2^bin_bits rows */
    uint32_t direct_bins; /* with more bins than this, records are pushed by write combining */
    double direct_rate;   /* if an iteration has more records than this, its records are pushed by
                             write combining, too */
    redcc_int round;      /* maximum number of iterations of a round */
    redcc_int round_of_spans; /* maximum number of iterations of a round if a stream has spans */
    size_t least_budget; /* memory for records in bytes, to which a share of the size of the arrays
                            is added */
    size_t whole_budget; /* memory for records in bytes if the loop must be one round */
    size_t copies_bytes; /* maximum size of arrays that have private copies, in bytes */
    size_t one_thread_bytes; /* minimum total size of the arrays for which one thread uses bins, in
                                bytes */
    double trial;            /* with REDCC_METHOD=binning: the seconds that a trial may lose
                                (redcc_bins_begin); 0: no trial */
};

extern struct bins_tuning redcc_bins_tuning;

/** The size in bytes of one row of each array of a stream. */
size_t redcc_stream_row(const redcc_stream *stream);

/** The window of `rows`, with at least `margin` more rows on either side. If the number of bins is
 * too small for `threads` threads, bins are halved while each has some hundreds of records per
 * thread. `rate` * `iterations` is the total number of records. The result has no rows if the range
 * of rows is too large. */
struct window redcc_window(const redcc_stream *stream, struct row_range rows, uint64_t margin,
                           int threads, double rate, double iterations);

/** The window for private copies: all rows are in one bin. */
struct window redcc_copied_window(struct row_range rows, uint64_t margin);

/** The rows of a window. */
static inline struct row_range redcc_window_rows(struct window window) {
    return window.rows == 0
               ? redcc_no_rows
               : (struct row_range){window.first, window.first + (redcc_int)(window.rows - 1)};
}

#endif
