/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** One execution for the runtime: the trip count, the arrays, the reads. */
#ifndef EMIT_CALL_H
#define EMIT_CALL_H

#include "emit/base/loop.h"

/** trip.c: declares redcc__lower, redcc__bound, redcc__trip and redcc__final. Returns further
 *  conditions for entering the parallel form; `site` is the loop's. */
const char *write_trip_count(loop_text *loop, writer *out, const char *site);

/** describe.c: the static objects that describe the loop. */
void write_description(loop_text *loop, writer *out);

/** The key of one execution. */
void fill_key(loop_text *loop, writer *out);

/** extents.c: redcc__known, for sources with ranges known before the inspection. */
bool has_affine_extents(const loop_text *loop);
void declare_extents(loop_text *loop, writer *out);
void fill_extents(loop_text *loop, writer *out);
/** bounds.c: the same of elements between bounds. */
void fill_bounded_extent(loop_text *loop, writer *out, unsigned number);
/** Is memory read before the loop, by system calls, that the program might not read? */
bool reads_by_system(const loop_text *loop);
/** The condition under which the ranges are known, for entering the parallel form; NULL: always. */
const char *extents_condition(const loop_text *loop);

#endif
