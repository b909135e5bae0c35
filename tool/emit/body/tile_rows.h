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
/** A thread's rows, in its member function. */
void declare_tile_rows(loop_text *loop, writer *out);
/** Their address, as the tile's function takes it. */
extra_value tile_rows_value(loop_text *loop);

/** Statements before the loop over columns, and after it; "": none. */
const char *take_tile_row(loop_text *loop);
const char *keep_tile_row(loop_text *loop);

#endif
