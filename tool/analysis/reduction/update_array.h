/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds the array that an update belongs to, checks the array's base, and compares the update with
 *  other updates of the array. */
#ifndef ANALYSIS_UPDATE_ARRAY_H
#define ANALYSIS_UPDATE_ARRAY_H

#include "analysis/loop/loop_analysis.h"

/** The operator of an update, and whether the order of such updates matters. */
typedef struct update_kind {
    reduction_operator op;
    bool needs_order;
    int64_t limit; /* for REDUCTION_SATURATING */
} update_kind;

/** Is the element reached through a local pointer that the loop sets once and otherwise only
 *  steps? */
bool update_is_by_local_pointer(const loop_analysis *j, const loop_access *update);

/** For a target s.b[i] or s->b[i] with an array b, the expression s.b or s->b. For any other
 *  target, `base`. */
const ir_node *update_base_of(const ir_node *target, const ir_node *base);

/** The invariant table from which iterations load a pointer or array: `rows` for rows[k], and
 *  `object` for object[k].row. NULL if `base` itself is invariant, or if the loop may store
 *  pointers to the table. Also NULL if the path to `base` does not begin with an invariant, or
 *  contains a union or a cast to another type. */
const ir_node *update_table_of(const loop_analysis *j, const ir_node *base);

/** Checks that the base is a pointer or array that is invariant and can be read before the loop, or
 *  is reached from a table (update_table_of). Otherwise refuses the loop. Also refuses it if all
 *  iterations update the same element, unless an update with a varying subscript of this array is
 *  known already. */
bool update_check_base(loop_analysis *j, const loop_access *update, const char *name);

/** Stores in *number the index in j->arrays of the array behind the update's base. Adds the array
 *  if it is new. Refuses the loop if the update is incompatible with other updates of the array;
 *  otherwise sets order_is_kept and is_interleaved if they require it. */
bool update_array_find(loop_analysis *j, const loop_access *update, update_kind kind,
                       unsigned *number);

/** Classifies the access as an update of array `number`. Adds an update of the element or row
 *  `target` by `statement`, unless there is one for this statement already. */
void update_array_add(loop_analysis *j, loop_access *update, update_kind kind,
                      const ir_node *statement, const ir_node *target, unsigned number);

#endif
