/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises updates made by a function that receives the address of an element or row, or an
 *  array and subscripts:
 *
 *      add(&R[k], e); add_vector(b[i], f); raise(&cell[k].high, v); add_at(R, k, e);
 *
 *  The function must have a body here, and write only through one argument, inside the element or
 *  row. */
#ifndef ANALYSIS_UPDATE_CALL_H
#define ANALYSIS_UPDATE_CALL_H

#include "analysis/loop/loop_analysis.h"

typedef struct update_call {
    const ir_node *statement; /* NULL if the call is no such update */
    const ir_node *target;    /* the element or row that the call updates */
    bool has_operator;        /* all updates use one operator, and the function does not read the
                               * element otherwise */
    bool is_by_member; /* the array is a member of the record to which the argument points, so the
                        * call would not find a private copy */
    reduction_operator op;
} update_call;

/** Recognises an update by `call`, an IR_CALL in the loop's text that writes memory. */
update_call update_call_of(const loop_analysis *j, const ir_node *call);

/** Gives CLASS_SELF to the call's reads of the memory that it updates. */
void update_call_mark_reads(loop_analysis *j, const update_call *update);

#endif
