/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What a loop leaves besides its updates of arrays, and what its iterations hand on. */
#ifndef EMIT_VALUES_H
#define EMIT_VALUES_H

#include "emit/loop.h"

/** distribution.c: after the loop, where it has run in parallel, the stores that are made then. */
void write_distributed_stores(loop_text *loop, writer *out);

/** scalars.c: room for the operands that each iteration keeps of scalar updates; whether there was
 *  memory for it, as a condition (NULL: there are no such updates); */
void declare_operands(loop_text *loop, writer *out);
const char *operands_are_there(loop_text *loop);
/** in an iteration, variables for what is put together, that no update was executed yet of those
 *  that may not be, and what number `number` does; */
void declare_repeated_operands(loop_text *loop, writer *out);
void note_no_operands(loop_text *loop, writer *out);
void write_operand(loop_text *loop, writer *out, unsigned number, const char *value);
/** after the loop, the updates themselves. */
void apply_operands(loop_text *loop, writer *out);

/** forward.c: variables for what an iteration stores and reads again, of the slice only or all; */
void declare_forwards(loop_text *loop, writer *out, bool of_slice);
/** the variable that this node is to be read from, or NULL; */
const char *forward_read_name(const loop_text *loop, const ir_node *node);
/** the assignment of the stored value to the variable, and from there to the element, which is a
 *  statement of its own. */
void write_forward(loop_text *loop, writer *out, const forwarded_store *store, ir_c_rename rename,
                   void *context);
void write_forwarded_store(loop_text *loop, writer *out, const forwarded_store *store,
                           ir_c_rename rename, void *context);

void declare_last_values(loop_text *loop, writer *out);
/** Stores the last values, of the thread that has them; or from there into the user's variables. */
void write_last_values(loop_text *loop, writer *out, bool into_variables);

/** lasting.c: private variables assigned in some iterations only, whose last value is wanted; what
 *  notes the value and when it was assigned, of all threads or of one in the region; */
void declare_sought_values(loop_text *loop, writer *out, bool in_region);
/** the note after an assignment of private variable `number`; */
void write_note(loop_text *loop, writer *out, unsigned number);
/** the latest of all threads', at the end of the region; and from there to the variables. */
void gather_sought_values(loop_text *loop, writer *out);
void take_sought_values(loop_text *loop, writer *out);

/** step.c: variables that each iteration moves by a constant: their values when the loop is
 *  entered, as redcc__from_N, those that the header gives them or the others'; what private
 * variable `number` begins an iteration with, " = ..."; their values after the loop. */
void declare_entry_values(loop_text *loop, writer *out, bool by_header);
const char *stepped_value(loop_text *loop, unsigned number);
void write_stepped_values(loop_text *loop, writer *out);

#endif
