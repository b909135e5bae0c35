/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The steps of plan_bins: finding nests, spans, rows, groups, and records that are alike. */
#ifndef PLAN_BINS_PARTS_H
#define PLAN_BINS_PARTS_H

#include "plan/bins.h"

/** Sets bins->nests. There are none if they would change the order of an element's updates. */
void find_nests(const loop_facts *facts, bins_plan *bins);
/** The nest of update number `i`, for any rows, or NULL if it has none, or nests are not used. */
const bins_nest *nest_at(const bins_plan *bins, unsigned i);

/** Sets bins->spans. Requires find_nests. */
void find_bins_spans(const loop_plan *plan, bins_plan *bins);

/** Returns the largest part of the array in which the updated element is at a constant offset, or
 *  at an offset that depends only on counters of the nest (`nest` may be NULL). */
const ir_node *outermost_row(const loop_facts *facts, const reduction_update *update,
                             const bins_nest *nest);

/** Sets bins->row_bytes. Rows are elements or, if `wide`, the structures or arrays in which the
 * loop updates several elements. */
void find_rows(const loop_facts *facts, bins_plan *bins, bool wide);

/** Can the element be addressed by the numbers of its row and of its part? It must have the array's
 *  element type, which members of records need not have, and that type's alignment. Its offset in
 *  the row must be a multiple of its size. Unless the array is scattered, the row's offset from the
 *  base must be a multiple of row_bytes. */
bool is_in_step(const loop_facts *facts, const bins_plan *bins, const reduction_update *update);

/** Do the updates' rows have the same number, counted from their arrays' bases? Correct only if
 * is_in_step holds for both. */
bool is_same_row(const loop_facts *facts, const bins_plan *bins, const reduction_update *left,
                 const reduction_update *right);

/** Sets rows (find_rows), the updates of each record and the arrays of each stream. If `together`,
 * arrays that are always updated together share a stream. Returns false if an update is outside of
 * the body. */
bool group_updates(arena *a, const loop_facts *facts, bins_plan *bins, bool wide, bool together);

/** Do both records make the same updates, except for rows and operands' values? Both must belong to
 * one stream. */
bool records_are_alike(const loop_facts *facts, const bins_plan *bins, const bins_record *a,
                       const bins_record *b);

#endif
