/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which array an update goes to: that its base stays, and what its other updates are. */
#ifndef ANALYSIS_UPDATE_ARRAY_H
#define ANALYSIS_UPDATE_ARRAY_H

#include "analysis/loop/loop_analysis.h"

/** Does the order of the updates matter? */
typedef struct update_kind {
    reduction_operator op;
    bool needs_order;
    int64_t limit; /* REDUCTION_SATURATING */
} update_kind;

/** Is the element reached through a local pointer that is set once, in the loop? */
bool update_is_by_local_pointer(const loop_analysis *j, const loop_access *update);

/** Of s.b[i] and s->b[i] with an array b the base is all of s.b or s->b. */
const ir_node *update_base_of(const ir_node *target, const ir_node *base);

/** Where a pointer or array in memory is that iterations find anew: of rows[k] and of object[k].row
 *  what stays in all of them, `rows` and `object`. NULL where `base` itself stays, or where the way
 *  to it does not begin at something that stays. */
const ir_node *update_table_of(const loop_analysis *j, const ir_node *base);

/** Does the base stay the same array in all iterations, and can it be read before the loop? Refuses
 *  where not. */
bool update_check_base(loop_analysis *j, const loop_access *update, const char *name);

/** The number in j->arrays of the array behind the update's base, which is added where it is new;
 *  refuses updates that do not go together. */
bool update_array_find(loop_analysis *j, const loop_access *update, update_kind kind,
                       unsigned *number);

/** Adds the update, by `statement`, of `target`, an element or row of that array. */
void update_array_add(loop_analysis *j, loop_access *update, update_kind kind,
                      const ir_node *statement, const ir_node *target, unsigned number);

#endif
