/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A copy of the user's body: its bytes, the edits to them, and the statements that are printed from
 * the IR instead.
 */
#ifndef EMIT_BODY_COPY_H
#define EMIT_BODY_COPY_H

#include "emit/base/loop.h"
#include "emit/text/edit.h"
#include "emit/text/print.h"

typedef struct body_copy {
    printer printer; /* first: the printer's hook reaches the other fields through it */
    loop_text *loop;
    edit_list edits;
    VECTOR(const ir_node *) printed; /* statements to be printed from the IR */
    const ir_node *within;           /* the statement being printed, which the hook must not replace
                                      * again, or NULL */
} body_copy;

/** A hook that spells a node of the body; `context` is the loop_text. It returns the local name of
 * an array's base, of an own element, of a forwarded value, or of a variable passed by address. It
 * returns NULL for other nodes, which are spelled as the user wrote them. */
const char *local_name(const ir_node *node, void *context);
/** Like local_name, for code that the program may not execute: signed arithmetic wraps around. */
const char *wrapping_name(const ir_node *node, void *context);

/** Replaces bytes [begin, end). The line ends among them are kept, so that the following text keeps
 *  its line number. */
void replace_bytes(body_copy *copy, uint32_t begin, uint32_t end, const char *text);

/** Marks the statement to be printed from the IR instead of copied. If it is part of a macro's
 * expansion, the whole expanded statement is marked, and if one macro call expands to several
 * statements, the block around them. Records an obstacle if that is impossible. */
void print_instead(body_copy *copy, const ir_node *statement);
bool is_printed(const body_copy *copy, const ir_node *node);

/** Is the node a bound of the loop over columns while the body for tiles is written? The tile's
 * bounds replace such bounds. */
bool is_clipped(const loop_text *loop, const ir_node *node);
/** In a loop with tiles, clips the loop over columns to those of the tile. */
void clip_columns(body_copy *copy);
/** In a loop with tiles, writes the text after the loop over columns. Call it after all insertions
 * at the end of that loop's body, because these may be at the same position and must come first. */
void leave_columns(body_copy *copy);

/** Inserts the checks by which a thread skips the rest of an inner iteration that updates none of
 * its elements (skip.c). */
void skip_inner_iterations(body_copy *copy, const ir_node *node);

#endif
