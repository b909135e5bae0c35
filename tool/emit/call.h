/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes the data that the runtime gets for one execution: trip count, arrays, key, and reads. */
#ifndef EMIT_CALL_H
#define EMIT_CALL_H

#include "emit/base/loop.h"

/** Declares redcc__lower, redcc__bound, redcc__trip and, if needed, redcc__final (trip.c). Returns
 *  the conditions under which the parallel form may be entered. `site`: the name of the loop's
 *  redcc_site. */
const char *write_trip_count(loop_text *loop, writer *out, const char *site);

/** The counter's value after the iterations that were executed in parallel. */
const char *counter_after(loop_text *loop);

/** Writes the static objects that describe the loop (describe.c). */
void write_description(loop_text *loop, writer *out);

/** Writes the statements that set the key of one execution. */
void fill_key(loop_text *loop, writer *out);

/** Extents (address ranges) of sources that are known before the inspection. An affine extent
 * reaches from the first iteration's row to the last one's. has_affine_extents tells whether there
 * are any of these. fill_extents writes the extents to redcc__known (extents.c). If an extent may
 * turn out to be unknown, declare_extents declares redcc__unknown, which says so. */
bool has_affine_extents(const loop_text *loop);
void declare_extents(loop_text *loop, writer *out);
void fill_extents(loop_text *loop, writer *out);
/** Writes the extent of source `number`, which consists of the elements between two bounds
 * (bounds.c). */
void fill_bounded_extent(loop_text *loop, writer *out, unsigned number);
/** Does the generated text read memory before the loop that the program might not read? Such reads
 * use loads that cannot fault. */
bool reads_by_system(const loop_text *loop);
/** Returns a C condition that is true if all extents are known. If it is false, the parallel form
 * must not be entered. NULL: they are always known. */
const char *extents_condition(const loop_text *loop);

#endif
