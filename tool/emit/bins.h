/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the form for in-order binning is made of: which updates share a record, what it holds. */
#ifndef EMIT_BINS_H
#define EMIT_BINS_H

#include "emit/loop.h"

enum {
    MOST_STREAM_ARRAYS = 4,   /* REDCC_STREAM_ARRAYS of redcc/bins.h */
    MOST_RECORD_OPERANDS = 4, /* REDCC_VALUES_4 there */
    MOST_RECORD_UPDATES = 8
};

/** A record that the body appends: of one update, or of several that follow each other, of one row
 *  of an array or of rows of different arrays at one subscript. */
typedef struct bins_record {
    unsigned update_count;
    const reduction_update *updates[MOST_RECORD_UPDATES]; /* as they follow; the first appends it */
    unsigned stream;
    unsigned operand_count;
    const ir_node *operands[MOST_RECORD_OPERANDS];
    unsigned tag;
    const char *text; /* of the updates, on elements and a record */
} bins_record;

/** The records of an array, or of arrays that are updated nowhere but together. */
typedef struct bins_stream {
    unsigned array_count;
    unsigned arrays[MOST_STREAM_ARRAYS];
    const char *types[MOST_RECORD_OPERANDS]; /* of a record's values; NULL: no more */
    unsigned tag_count;
} bins_stream;

struct bins_text {
    unsigned record_count;
    bins_record *records; /* in each stream as the updates follow */
    unsigned stream_count;
    bins_stream *streams;
    int64_t *row_bytes;    /* of each array, by number: of an element, or of several side by side */
    uint32_t told_sources; /* bits, by number: their reads are told */
};

/** bins_row.c: sets row_bytes; rows are elements, or where `wide` and several elements side by side
 *  are updated, these. */
void find_rows(const loop_text *loop, struct bins_text *bins, bool wide);

/** Has a row of the array several elements? */
bool is_wide_row(const loop_text *loop, const struct bins_text *bins, unsigned array);

/** Which part of its row the update's element is, counted in elements; find_rows has been called.
 */
unsigned part_of_row(const loop_text *loop, const struct bins_text *bins,
                     const reduction_update *update);

/** Has the element the array's type (members of its records may have others) and that type's
 *  alignment, and lies it in step:
 *  a multiple of its own size into its row, and that a multiple of row_bytes away from the base? */
bool is_in_step(const loop_text *loop, const struct bins_text *bins,
                const reduction_update *update);

/** Has the updates' row the same number, counted from its array's base in rows? Both are in step.
 */
bool is_same_row(const loop_text *loop, const struct bins_text *bins, const reduction_update *left,
                 const reduction_update *right);

/** bins_group.c: sets rows, records (their updates) and streams (their arrays): rows of elements,
 *  or `wide` ones; one stream for each array, or `together`, as few as are possible. False: an
 * update stands elsewhere than in the body. */
bool group_updates(loop_text *loop, struct bins_text *bins, bool wide, bool together);

/** How many values a record of the stream holds. */
unsigned stream_value_count(const bins_stream *stream);

#endif
