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
    int source; /* its number in the plan; SOURCE_NOT_LOGGED: the row is of an update */
    unsigned array;
    bool is_unconditional;
    const ir_node
        *place; /* in a span, the node at which the loop accesses the row; otherwise NULL */
} logged_row;

typedef VECTOR(logged_row) row_list;

typedef struct inspector {
    printer printer; /* first: the printer's hook reaches the other fields through it */
    loop_text *loop;
    bool *update_logged;   /* by update */
    bool *source_logged;   /* by source of the facts */
    bool *is_mentioned;    /* by variable: named in the printed text */
    bool is_unconditional; /* the current code may be evaluated when the program does not */
    unsigned loop_count;   /* loops of a called function around the current code */
    const source_loop *loops;
    const ir_node *span;  /* the span whose first or last row is being spelled; NULL: none */
    const ir_node *place; /* the place of that row's access */
    bool is_at_last;      /* the last row is being spelled, not the first */
    const ir_node *hulls; /* the outermost loop whose hulls are being logged; NULL: none */
    row_list recent;      /* the rows logged by the last statements of the text */
    size_t recent_end;    /* where they end in the text; statements follow if the text is longer */
} inspector;

bool logged_same(const logged_row *a, const logged_row *b);
/** Is the row logged as an update, not as a read? */
bool logged_is_update(const logged_row *item);
/** The number of the updated array, or of the source. */
unsigned logged_number(const logged_row *item);

/** The printer's hook that spells names in the slice, and records each variable in is_mentioned.
 *  context: the inspector. */
const char *inspector_note_variable(const ir_node *node, void *context);
/** The text of &row; or, if the program may not execute the access, of the address as a number,
 *  because C defines a pointer only within its object. `counter`: that of a span around the row; or
 *  NULL. */
const char *log_address_text(inspector *self, const ir_node *row, const ir_variable *counter);
/** The row as the slice spells it, with variables in place of stored values. */
const char *log_row_text(inspector *self, const ir_node *row);

/** Logs an update of a row of array `number` (`is_update`), or a read of one of source `number`.
 *  `base`: an invariant array or pointer, for rows that may be logged by their number; or NULL. */
void log_row(inspector *self, const ir_node *row, bool is_update, unsigned number,
             const ir_node *base);
/** The loop over constants between the span and the place that has this counter; NULL: none. */
const ir_node *vector_loop_of(const ir_node *span, const ir_node *place,
                              const ir_variable *counter);
/** Logs the range of a span from its first row, whose address is in redcc__begin_N, N being `row`,
 * to the last one, `item`. */
void log_up_to(inspector *self, const logged_row *item, unsigned row, const ir_variable *counter);
/** Logs the address of an update, unless it was just logged. */
void log_update(inspector *self, const reduction_update *update);
/** Logs the address of a read, within copies of the loops of a called function that contain it. */
void log_read(inspector *self, const loop_source *read, int number);

#endif
