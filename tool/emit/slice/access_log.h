/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The inspector being written: the rows logged so far, and how the current code is spelled. */
#ifndef EMIT_SLICE_ACCESS_LOG_H
#define EMIT_SLICE_ACCESS_LOG_H

#include "emit/base/loop.h"
#include "emit/text/print.h"
#include "support/vector.h"

/** A row whose address is logged. */
typedef struct logged_row {
    const ir_node *row;
    int source; /* number in the plan; SOURCE_NOT_LOGGED: it is the row of an update */
    unsigned array;
    bool is_unconditional;
    const ir_node
        *place; /* in a span, the node at which the loop accesses the row; otherwise NULL */
} logged_row;

typedef VECTOR(logged_row) row_list;

typedef struct inspector {
    printer printer; /* first: the printer's hook reaches the other fields through it */
    loop_text *loop;
    bool *update_logged;   /* indexed by update: is it logged? */
    bool *source_logged;   /* per facts->sources[i]: is it logged? */
    bool *is_mentioned;    /* indexed by variable: is it named in the printed text? */
    bool is_unconditional; /* the current code may be evaluated when the program does not */
    unsigned loop_count;   /* number of loops of a called function around the current code */
    const source_loop *loops;
    const ir_node *span;  /* the span whose first or last row is being spelled, or NULL */
    const ir_node *place; /* where the loop accesses that row */
    bool is_at_last;      /* the last row is being spelled, not the first */
    const ir_node *hulls; /* the outermost loop whose hulls are being logged, or NULL */
    row_list recent;      /* the rows logged by the last statements of the text */
    size_t recent_end;    /* end of these statements in the text; if the text is longer, other
                           * statements follow them */
} inspector;

bool logged_same(const logged_row *a, const logged_row *b);
/** Is the row logged as an update, not as a read? */
bool logged_is_update(const logged_row *item);
/** The number of the updated array, or of the source. */
unsigned logged_number(const logged_row *item);

/** The printer's hook that spells names in the slice, and records each variable in is_mentioned.
 *  `context`: the inspector. */
const char *inspector_note_variable(const ir_node *node, void *context);
/** Returns the text of &row. If the program may not execute the access, the text is instead a
 * number, because C defines a pointer only within its object. `counter`: the counter of a span
 * around the row, or NULL. */
const char *log_address_text(inspector *self, const ir_node *row, const ir_variable *counter);
/** The row as the slice spells it, with the variables that replace forwarded stores and own
 * elements. */
const char *log_row_text(inspector *self, const ir_node *row);

/** Logs an update of a row of array `number` (`is_update`), or a read of a row of source `number`.
 * `base`: an invariant array or pointer, for rows that may be logged by their number; or NULL. */
void log_row(inspector *self, const ir_node *row, bool is_update, unsigned number,
             const ir_node *base);
/** Logs the range of a span from its first row, whose address is in redcc__begin_N (N is `row`), to
 * the last row, `item`. */
void log_up_to(inspector *self, const logged_row *item, unsigned row, const ir_variable *counter);
/** Logs the address of an update, unless it was just logged. */
void log_update(inspector *self, const reduction_update *update);
/** Logs the address of a read, within copies of the loops of a called function that contain it. */
void log_read(inspector *self, const loop_source *read, int number);

#endif
