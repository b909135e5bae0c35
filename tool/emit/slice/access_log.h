/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The inspector being written: the addresses logged so far, and the form of logging. */
#ifndef EMIT_SLICE_ACCESS_LOG_H
#define EMIT_SLICE_ACCESS_LOG_H

#include "emit/base/loop.h"
#include "emit/text/print.h"
#include "support/vector.h"

/** A row whose address is logged. */
typedef struct logged_row {
    const ir_node *row;
    int source; /* or SOURCE_NOT_LOGGED, for an update */
    unsigned array;
    bool is_unconditional;
    const ir_node *place; /* in a span: where the loop accesses it; otherwise NULL */
} logged_row;

typedef VECTOR(logged_row) row_list;

typedef struct inspector {
    printer printer; /* first: the printer's hook reaches the other fields through it */
    loop_text *loop;
    bool *update_logged;   /* by update */
    bool *source_logged;   /* by the facts' source */
    bool *is_mentioned;    /* by variable: named in the printed text */
    bool is_unconditional; /* the current code may be evaluated when the program does not */
    unsigned loop_count;   /* loops of a called function around the current code */
    const source_loop *loops;
    const ir_node *span;  /* the span whose first or last row is being spelled; NULL: none */
    const ir_node *place; /* the place of that row's access */
    bool is_at_last;      /* the last row, not the first */
    row_list recent;      /* logged since the slice's last other statement */
    size_t recent_end;    /* length of the text when the last of them was */
} inspector;

bool logged_same(const logged_row *a, const logged_row *b);
/** Is it logged as an update, not as a read? */
bool logged_is_update(const logged_row *item);
/** The number of the updated array, or of the source. */
unsigned logged_number(const logged_row *item);

/** The printer's hook for spellings: records the variables. context: the inspector. */
const char *inspector_note_variable(const ir_node *node, void *context);
/** &row, or a number if the program may not compute it: a pointer is defined only within its
 *  object. For a span: for the counter's present value; otherwise counter is NULL. */
const char *log_address_text(inspector *self, const ir_node *row, const ir_variable *counter);
/** In the slice's names: its stored values are in variables. */
const char *log_row_text(inspector *self, const ir_node *row);

/** Logs a row of array or source `number`, or probes it; `is_update` or read. `base`: an invariant
 *  array or pointer, for rows that may be logged by their number; or NULL. */
void log_row(inspector *self, const ir_node *row, bool is_update, unsigned number,
             const ir_node *base);
/** Is the counter one of a loop over constants between the span and the place? */
const ir_node *vector_loop_of(const ir_node *span, const ir_node *place,
                              const ir_variable *counter);
/** The range from row number `row` of a list, from its first element on, whose address was saved,
 *  to this one. */
void log_up_to(inspector *self, const logged_row *item, unsigned row, const ir_variable *counter);
/** Logs the address of an update, unless it was just logged. */
void log_update(inspector *self, const reduction_update *update);
/** The same for a read, within the loops of a called function that contain it. */
void log_read(inspector *self, const loop_source *read, int number);

#endif
