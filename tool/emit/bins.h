/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the form for in-order binning is made of: which updates share a record, what it holds. */
#ifndef EMIT_BINS_H
#define EMIT_BINS_H

#include "emit/loop.h"

enum {
    MOST_STREAM_ARRAYS = 4, /* REDCC_STREAM_ARRAYS of redcc/bins.h */
    MOST_RECORD_OPERANDS = 4,
    MOST_RECORD_VALUES = 9, /* REDCC_VALUES_9 there */
    MOST_RECORD_UPDATES = 8,
    MOST_NEST_DEPTH = 3
};

/** Loops over constants around updates (bins_nest.c), the outermost first. */
typedef struct bins_nest {
    const ir_node *outermost; /* NULL: there are none */
    unsigned depth;
    struct nest_level {
        const ir_variable *counter; /* that counts up by 1 */
        int64_t first, trip;
    } levels[MOST_NEST_DEPTH];
} bins_nest;

/** A record that the body appends: of one update, or of several that follow each other, of one row
 *  of an array or of rows of different arrays at one subscript. Or of an update in a nest, in which
 *  each operand has a value for each part of the row. */
typedef struct bins_record {
    const bins_nest *nest; /* NULL: none */
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
    const char *types[MOST_RECORD_VALUES]; /* of a record's values; NULL: no more */
    unsigned tag_count;
} bins_stream;

struct bins_text {
    unsigned record_count;
    bins_record *records; /* in each stream as the updates follow */
    unsigned stream_count;
    bins_stream *streams;
    int64_t *row_bytes; /* of each array, by number: of an element, or of several side by side */
    bool has_nests;
    bins_nest *nests;      /* of each update, by number, where it has any */
    uint32_t told_sources; /* bits, by number: their reads are told */
};

/** bins_nest.c: sets nests. */
void find_nests(const loop_text *loop, struct bins_text *bins);

/** The nest of update number `i`; NULL: it has none, or this form has no nests. Of nest_of also
 *  where the array's rows are single elements. */
const bins_nest *nest_at(const struct bins_text *bins, unsigned i);
const bins_nest *nest_of(const loop_text *loop, const struct bins_text *bins,
                         const reduction_update *update);

/** Of which the node is the counter; NULL: of none. */
const struct nest_level *nest_level_of(const bins_nest *nest, const ir_node *node);

/** How many elements an update in it goes to; NULL: 1. */
unsigned nest_part_count(const bins_nest *nest);

/** The type that C promotes it to, by a name that needs no declaration; NULL: values of it are not
 *  kept. */
const char *kept_type(const ir_type *type);

/** What a counter is where the loops come to an element, which is counted from 0. */
int64_t nest_counter_value(const bins_nest *nest, const struct nest_level *level, unsigned part);

/** The same as C, of the counter's promoted type; NULL: the node is not a counter of the nest. */
const char *nest_counter_text(const loop_text *loop, const bins_nest *nest, const ir_node *node,
                              unsigned part);

/** bins_row.c: the largest part of the array that holds the element at a constant offset, or at one
 *  that counters of the nest (NULL: none) say. */
const ir_node *outermost_row(const loop_text *loop, const reduction_update *update,
                             const bins_nest *nest);

/** Sets row_bytes; rows are elements, or where `wide` and several elements side by side
 *  are updated, these. */
void find_rows(const loop_text *loop, struct bins_text *bins, bool wide);

/** Has a row of the array several elements? */
bool is_wide_row(const loop_text *loop, const struct bins_text *bins, unsigned array);

/** The position of the update's element in the row, counted in elements. In a nest, `part` is the
 *  number of the iteration. find_rows has been called. */
unsigned part_of_row(const loop_text *loop, const struct bins_text *bins,
                     const reduction_update *update, unsigned part);

/** The same as C, in the nest. */
const char *part_of_row_text(const loop_text *loop, const struct bins_text *bins,
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
