/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Preprocessing lines of a source file: libclang shows pragmas and untaken branches only in part.
 */
#ifndef FRONTEND_DIRECTIVES_H
#define FRONTEND_DIRECTIVES_H

#include "ir/ir.h"

/** All directives and _Pragma operators of the text, untaken branches included, in order, into
 *  unit->directives. Knows line splices, comments, strings, digraphs and trigraphs. */
void find_directives(arena *a, ir_unit *unit);
/** The same of any text; ranges are offsets in it. */
ir_directive *directives_in(arena *a, const char *text, size_t length, unsigned *count);

/** How many bytes the backslash and line end at `p` take; 0: none there. */
unsigned splice_length(const char *p, const char *end);
/** Behind the comment, string, character constant or splice that begins at `at`, before `end`; else
 *  the next byte. Thread-safe. */
const char *piece_end(const char *at, const char *end);

#endif
