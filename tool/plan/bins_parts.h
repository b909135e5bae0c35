/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** How plan_bins finds records: nests, rows, groups, records that are alike. */
#ifndef PLAN_BINS_PARTS_H
#define PLAN_BINS_PARTS_H

#include "plan/bins.h"

/** Sets nests. */
void find_nests(const loop_facts *facts, bins_plan *bins);
/** The nest of update number `i`, whatever the rows are; NULL: it has none, or none are used. */
const bins_nest *nest_at(const bins_plan *bins, unsigned i);

/** The largest part of the array that holds the element at a constant offset, or at one
 *  that counters of the nest (NULL: none) say. */
const ir_node *outermost_row(const loop_facts *facts, const reduction_update *update,
                             const bins_nest *nest);

/** Sets row_bytes; rows are elements, or where `wide` and several elements side by side
 *  are updated, these. */
void find_rows(const loop_facts *facts, bins_plan *bins, bool wide);

/** Has the element the array's type (members of its records may have others) and that type's
 *  alignment, and lies it in step:
 *  a multiple of its own size into its row, and that a multiple of row_bytes away from the base? */
bool is_in_step(const loop_facts *facts, const bins_plan *bins, const reduction_update *update);

/** Has the updates' row the same number, counted from its array's base in rows? Both are in step.
 */
bool is_same_row(const loop_facts *facts, const bins_plan *bins, const reduction_update *left,
                 const reduction_update *right);

/** Sets rows, records (their updates) and streams (their arrays): rows of elements,
 *  or `wide` ones; one stream for each array, or `together`, as few as are possible. False: an
 * update stands elsewhere than in the body. */
bool group_updates(arena *a, const loop_facts *facts, bins_plan *bins, bool wide, bool together);

/** Do both records make the same updates, but for the values? Both are of one stream. */
bool records_are_alike(const loop_facts *facts, const bins_plan *bins, const bins_record *a,
                       const bins_record *b);

#endif
