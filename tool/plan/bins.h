/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * In-order binning (redcc/bins.h, docs/methods.md): an update becomes a record, which holds the
 * values that the update reads except for the element itself. A function applies records to the
 * elements. Adjacent updates of one row (bins_row.c), or of several arrays at one subscript
 * (bins_group.c), share a record. So do all iterations of a loop with constant bounds (bins_nest.c)
 * or over a row (bins_span.c).
 *
 * Why it is sound: only the updates access the arrays, so they may be made later. The records of an
 * element are applied in the order of the loop. A record holds the values that its updates would
 * have read: its operands are evaluated at its first update, and none of its updates changes them.
 * The form is declined if an update cannot be split in this way.
 *
 * The body executes before its reads are compared with its writes. If the body may then fail
 * (unverified_uses.h), or leave results that a later execution does not replace (is_checked), the
 * inspector first records all reads and updated rows. The overlap guard compares them, as for a
 * plan. No iteration then reads what another one writes: each has the sequential loop's values,
 * whenever and however often it executes.
 *
 * Before the guard nothing is stored to memory that the loop reads. So an address that depends on
 * no variable of the iteration is the same in all iterations: only the first one of a chunk records
 * such reads.
 */
#ifndef PLAN_BINS_H
#define PLAN_BINS_H

#include "plan/plan.h"

enum {
    MOST_STREAM_ARRAYS = 4, /* REDCC_STREAM_ARRAYS (redcc/structures.h) */
    MOST_RECORD_OPERANDS = 4,
    MOST_RECORD_VALUES = 9, /* REDCC_VALUES_9 is the last one in redcc/bins.h */
    MOST_RECORD_UPDATES = 8,
    MOST_NEST_DEPTH = 3
};

/** The type in which a record stores a value: the value's type after C's promotions. */
typedef enum value_kind {
    VALUE_NONE,
    VALUE_INT,
    VALUE_UNSIGNED,
    VALUE_LONG,
    VALUE_UNSIGNED_LONG,
    VALUE_FLOAT,
    VALUE_DOUBLE
} value_kind;

/** The loops with constant bounds around an update (bins_nest.c), the outermost first. */
typedef struct bins_nest {
    const ir_node *outermost; /* NULL: there are none */
    unsigned depth;
    struct nest_level {
        const ir_variable *counter; /* incremented by 1 */
        int64_t first, trip;
    } levels[MOST_NEST_DEPTH];
} bins_nest;

/** An inner loop `for (j = FIRST; j < n; j++)` around one update of consecutive elements. The
 * update's operands are read when the record is applied (bins_span.c). */
typedef struct bins_span {
    const ir_node *loop;      /* NULL: none */
    const loop_span *counted; /* the loop's header */
    int64_t first;            /* the counter's first value */
    unsigned variable_count;  /* number of the iteration's variables whose values the record
                               * stores */
    const ir_variable *variables[MOST_RECORD_OPERANDS];
} bins_span;

/** A record that the body appends. It describes one of these:
 *  - one update;
 *  - adjacent updates of one row of an array, or of rows of different arrays at one subscript;
 *  - all iterations of an update in a span or in a nest. In a nest each operand has a value for
 *    each iteration. */
typedef struct bins_record {
    const bins_nest *nest; /* NULL: none */
    const bins_span *span; /* NULL: none */
    unsigned update_count;
    const reduction_update *updates[MOST_RECORD_UPDATES]; /* in textual order; the record is
                                                           * appended at the first one, before its
                                                           * nest or span */
    unsigned stream;
    unsigned operand_count;
    const ir_node *operands[MOST_RECORD_OPERANDS];
    unsigned tag; /* number, among the records of the stream, of the statements that apply this
                   * record */
} bins_record;

/** The records of an array, or of arrays that are always updated together. */
typedef struct bins_stream {
    unsigned array_count;
    unsigned arrays[MOST_STREAM_ARRAYS];
    value_kind kinds[MOST_RECORD_VALUES]; /* types of a record's values, then VALUE_NONE */
    unsigned tag_count;
} bins_stream;

typedef struct bins_plan {
    unsigned record_count;
    bins_record *records; /* in each stream in the order of the updates */
    unsigned stream_count;
    bins_stream *streams;
    int64_t *row_bytes; /* indexed by array: bytes of a row, which is an element or adjacent
                         * elements */
    bool has_nests;
    bins_nest *nests;         /* indexed by update number: its nest, if it has one */
    bins_span *spans;         /* indexed by update number: its span, if it has one */
    uint32_t guarded_sources; /* bit N: the reads of source N are logged as iterations execute */
    uint32_t varied_sources;  /* subset of guarded_sources: those to which later iterations of a
                               * chunk may add reads */
    bool is_checked; /* the body must not use unverified values (unverified.h), so the ranges of all
                      * reads and writes are found and compared before any iteration executes */
} bins_plan;

/** Sets plan->bins, or plan->no_bins: the reason why there are none. */
void plan_bins(loop_plan *plan);

/** The span whose records form the stream, or NULL if the stream has records of another kind. */
const bins_span *span_of_stream(const bins_plan *bins, unsigned stream);

/** The number of values in a record of the stream. */
unsigned stream_value_count(const bins_stream *stream);
/** Does a row of the array have several elements? */
bool is_wide_row(const loop_facts *facts, const bins_plan *bins, unsigned array);
/** Returns the update's row. Sets *offset to the byte offset of the updated element in its row; in
 * a nest, to the offset for counters of 0. */
const ir_node *row_in_bins(const loop_facts *facts, const bins_plan *bins,
                           const reduction_update *update, int64_t *offset);

/** The position of the update's element in the row, counted in elements. `part` is the number of
 *  the nest's iteration; 0 without a nest. Requires find_rows. */
unsigned part_of_row(const loop_facts *facts, const bins_plan *bins, const reduction_update *update,
                     unsigned part);

/** Returns the array element or member that holds the pointer through which an update of a
 * scattered array reaches its row. Returns NULL if the array is not scattered, or the pointer is
 * held elsewhere. */
const ir_node *row_load_of(const loop_facts *facts, const reduction_update *update);

/** Does the node name the updated element? If both subscripts contain equal calls, the calls count
 * as equal. */
bool is_updated_element(const ir_node *node, const ir_node *target);

/** The number of the operand that equals this node, or -1 if there is none. Two calls never count
 * as equal. */
int operand_number(const bins_record *record, const ir_node *node);

/** The level of the nest whose counter this node is, or NULL if there is none. */
const struct nest_level *nest_level_of(const bins_nest *nest, const ir_node *node);
/** The number of elements that an update in the nest updates; 1 if `nest` is NULL. */
unsigned nest_part_count(const bins_nest *nest);
/** The nest of an update, or NULL if it has none, nests are not used, or rows are single
 * elements. */
const bins_nest *nest_of(const loop_facts *facts, const bins_plan *bins,
                         const reduction_update *update);
/** The value of a counter when the loops reach element number `part`, counted from 0. */
int64_t nest_counter_value(const bins_nest *nest, const struct nest_level *level, unsigned part);

/** The type to which C promotes a value of this type; VALUE_NONE: records do not store it. */
value_kind value_kind_of(const ir_type *type);

#endif
