/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds preprocessing directives in a source text, because libclang does not show all pragmas and
 *  untaken branches. */
#ifndef FRONTEND_DIRECTIVES_H
#define FRONTEND_DIRECTIVES_H

#include "ir/ir.h"

/** Stores all directives and _Pragma operators of the text in unit->directives, in order, including
 *  those in untaken branches. Handles line splices, comments, strings, digraphs and trigraphs. */
void find_directives(arena *a, ir_unit *unit);
/** The directives of any text; their ranges are offsets in that text. */
ir_directive *directives_in(arena *a, const char *text, size_t length, unsigned *count);

/** The length in bytes of the line splice (backslash and line end) at `p`; 0 if there is none. */
unsigned splice_length(const char *p, const char *end);
/** The end of the comment, string, character constant or splice that begins at `at`, not beyond
 *  `end`. If none begins there, at + 1. Thread-safe. */
const char *piece_end(const char *at, const char *end);

#endif
