/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Values that rows of tiles keep from tile to tile (plan/tiles.h). */
#ifndef EMIT_BODY_TILE_ROWS_H
#define EMIT_BODY_TILE_ROWS_H

#include "emit/base/extra.h"
#include "emit/base/loop.h"

/** Does the loop have a form for tiles that keeps values? */
bool has_tile_rows(const loop_text *loop);
/** struct redcc__row_...: a row's values. */
void declare_tile_row(loop_text *loop, writer *out);
/** The array of a thread's rows, in the function that each thread calls. */
void declare_tile_rows(loop_text *loop, writer *out);
/** The address of that array, as a parameter of the function for a tile. */
extra_value tile_rows_value(loop_text *loop);

/** The statements before the loop over columns, which take the row's values, and those after it,
 * which keep them; "": none. */
const char *take_tile_row(loop_text *loop);
const char *keep_tile_row(loop_text *loop);

#endif
