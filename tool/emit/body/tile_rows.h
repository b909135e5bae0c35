/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Values of a row that are passed from one tile to the next (plan/tiles.h). */
#ifndef EMIT_BODY_TILE_ROWS_H
#define EMIT_BODY_TILE_ROWS_H

#include "emit/base/extra.h"
#include "emit/base/loop.h"

/** Does the loop have a form for tiles in which rows have such values? */
bool has_tile_rows(const loop_text *loop);
/** Declares struct redcc__row_..., which holds a row's values. */
void declare_tile_row(loop_text *loop, writer *out);
/** Declares the array of a thread's rows, in the function that each thread calls. */
void declare_tile_rows(loop_text *loop, writer *out);
/** The parameter by which the function for a tile gets the address of that array. */
extra_value tile_rows_value(loop_text *loop);

/** take_tile_row: the statements before the loop over columns, which load the row's values.
 * keep_tile_row: those after it, which store them. Both are "" if rows have no such values. */
const char *take_tile_row(loop_text *loop);
const char *keep_tile_row(loop_text *loop);

#endif
