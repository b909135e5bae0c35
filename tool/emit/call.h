/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One execution as the runtime sees it: how many iterations, which arrays, what they read.
 */
#ifndef EMIT_CALL_H
#define EMIT_CALL_H

#include "emit/base/loop.h"

/** trip.c: declares redcc__lower, redcc__bound, redcc__trip and redcc__final. Returns what else
 * must hold for the parallel form to be entered; `site` is the loop's. */
const char *write_trip_count(loop_text *loop, writer *out, const char *site);

/** describe.c: the static objects that describe the loop; the key of one execution. */
void write_description(loop_text *loop, writer *out);

void fill_key(loop_text *loop, writer *out);

/** extents.c: redcc__known, for the sources whose place is known before the inspection; */
bool has_affine_extents(const loop_text *loop);
void declare_extents(loop_text *loop, writer *out);
void fill_extents(loop_text *loop, writer *out);
/** bounds.c: the same of elements between bounds. */
void fill_bounded_extent(loop_text *loop, writer *out, unsigned number);
/** Is memory read before the loop, by system calls, that the program may not come to? */
bool reads_by_system(const loop_text *loop);
/** what must hold of them for the parallel form to be entered, or NULL. */
const char *extents_are_known(const loop_text *loop);

#endif
