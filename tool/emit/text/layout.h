/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Lays out a copy of the user's bytes into which text was inserted. */
#ifndef EMIT_TEXT_LAYOUT_H
#define EMIT_TEXT_LAYOUT_H

#include "support/buffer.h"

/**
 * Appends the marked text (origin.h), whose first byte is at `column` (from 0) of the file's line
 * `line`. A line of the user's with inserted text is divided if it has more than 100 columns, or if
 * the inserted text has several statements: what is inserted before a statement gets lines of its
 * own, and `#line` directives make all parts belong to the user's line. Other lines stay as they
 * are.
 */
void layout_copy(buffer *out, const char *marked, unsigned line, unsigned column);

/** Appends the marked text of a directive and a line end. Lines of more than 100 columns are broken
 * after commas and closing parentheses. */
void layout_directive(buffer *out, const char *marked);

#endif
