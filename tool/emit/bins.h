/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the form for in-order binning is made of: which updates share a record, what it holds. */
#ifndef EMIT_BINS_H
#define EMIT_BINS_H

#include "emit/loop.h"

enum {
    MOST_STREAM_ARRAYS = 4,  /* REDCC_STREAM_ARRAYS of redcc/bins.h */
    MOST_RECORD_OPERANDS = 4 /* REDCC_VALUES_4 there */
};

/** A record that the body appends: of one update, or of several at one subscript that follow each
 *  other, of different arrays. */
typedef struct bins_record {
    unsigned update_count;
    const reduction_update *updates[MOST_STREAM_ARRAYS]; /* as they follow; the first appends it */
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
    uint32_t told_sources; /* bits, by number: their reads are told */
};

/** bins_group.c: sets records (their updates) and streams (their arrays): one for each array, or
 *  `together`, as few as are possible. False: an update stands elsewhere than in the body. */
bool group_updates(loop_text *loop, struct bins_text *bins, bool together);

/** How many values a record of the stream holds. */
unsigned stream_value_count(const bins_stream *stream);

#endif
