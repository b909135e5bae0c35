/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The inspector that is being written: what it has logged, and how it logs. */
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
} logged_row;

typedef VECTOR(logged_row) row_list;

typedef struct inspector {
    printer printer; /* first: the printer's hook gets at the rest through it */
    loop_text *loop;
    bool *update_logged;   /* by update */
    bool *source_logged;   /* by the facts' source */
    bool *is_mentioned;    /* by variable: in what was printed */
    bool is_unconditional; /* what is printed now may be evaluated where the program does not */
    unsigned loop_count;   /* around what is printed now, of a function that the loop calls */
    const source_loop *loops;
    row_list recent;   /* logged since the slice last did something else */
    size_t recent_end; /* length of the text when the last of them was */
} inspector;

bool logged_same(const logged_row *a, const logged_row *b);
/** Is it logged as updated, not as read? */
bool logged_is_update(const logged_row *item);
/** The number of the array that is updated, or of the source. */
unsigned logged_number(const logged_row *item);

/** The printer's hook for spellings: notes the variables. context: the inspector. */
const char *inspector_note_variable(const ir_node *node, void *context);
/** &row, or, where the program may not come to it, as a number: a pointer has a meaning only within
 *  its object. Of a span: for the counter's present value; else counter is NULL. */
const char *log_address_text(inspector *self, const ir_node *row, const ir_variable *counter);
/** As the slice names things: what it has stored is in variables. */
const char *log_row_text(inspector *self, const ir_node *row);

/** Logs a row of array or source `number`, or probes it; `is_update` or read. `base`: of an array
 *  or pointer that no iteration changes, for rows that may be logged by their number; or NULL. */
void log_row(inspector *self, const ir_node *row, bool is_update, unsigned number,
             const ir_node *base);
/** Row number `row` of a list, from its first element on, whose address was noted, to this one. */
void log_up_to(inspector *self, const logged_row *item, unsigned row, const ir_variable *counter);
/** Logs what an update writes, unless that was just logged; */
void log_update(inspector *self, const reduction_update *update);
/** and what is read, in the loops of a function that is called where it is there. */
void log_read(inspector *self, const loop_source *read, int number);

#endif
