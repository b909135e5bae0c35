/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Updates made by a function that gets the address of an element or row, or an array and
 * subscripts:
 *
 *     add(&R[k], e);    add_vector(b[i], f);    raise(&cell[k].high, v);    add_at(R, k, e);
 *
 * The function has a body here. It writes only through one argument, within the element or row.
 */
#ifndef ANALYSIS_UPDATE_CALL_H
#define ANALYSIS_UPDATE_CALL_H

#include "analysis/loop/loop_analysis.h"

typedef struct update_call {
    const ir_node *statement; /* NULL: the call is no such update */
    const ir_node *target;    /* the element or row */
    bool has_operator;        /* one operator, and the element is not read otherwise */
    bool is_by_member; /* its array is a member of the record that the argument points to: the call
                        * would not find a private copy */
    reduction_operator op;
} update_call;

/** `call`: an IR_CALL of the loop's text that writes memory. */
update_call update_call_of(const loop_analysis *j, const ir_node *call);

/** The reads, by the call, of the memory that it updates get CLASS_SELF. */
void update_call_mark_reads(loop_analysis *j, const update_call *update);

#endif
