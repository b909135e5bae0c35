/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds the array of an update, checks the array's base, and compares the update with the array's
 *  others. */
#ifndef ANALYSIS_UPDATE_ARRAY_H
#define ANALYSIS_UPDATE_ARRAY_H

#include "analysis/loop/loop_analysis.h"

/** The operator of an update, and whether the order of such updates matters. */
typedef struct update_kind {
    reduction_operator op;
    bool needs_order;
    int64_t limit; /* REDUCTION_SATURATING */
} update_kind;

/** Is the element reached through a local pointer that is set once, in the loop, and otherwise
 * only stepped? */
bool update_is_by_local_pointer(const loop_analysis *j, const loop_access *update);

/** s.b or s->b, for a target s.b[i] or s->b[i] with an array b; for any other target `base`. */
const ir_node *update_base_of(const ir_node *target, const ir_node *base);

/** The table from which iterations load a pointer or array: of rows[k] and of object[k].row the
 *  invariant part, `rows` and `object`. NULL: `base` itself is invariant, the path to it begins
 *  with no invariant or has a union or type punning, or the loop may store to the table. */
const ir_node *update_table_of(const loop_analysis *j, const ir_node *base);

/** Is the base invariant and readable before the loop, or reached from a table (update_table_of)?
 *  Refuses other bases, and a target that is one element for the whole loop. */
bool update_check_base(loop_analysis *j, const loop_access *update, const char *name);

/** The number in j->arrays of the array behind the update's base, which is added if it is new;
 *  refuses incompatible updates. */
bool update_array_find(loop_analysis *j, const loop_access *update, update_kind kind,
                       unsigned *number);

/** Classifies the access as an update of array `number`. Adds the update, by `statement`, of the
 *  element or row `target`, unless the statement is already one. */
void update_array_add(loop_analysis *j, loop_access *update, update_kind kind,
                      const ir_node *statement, const ir_node *target, unsigned number);

#endif
