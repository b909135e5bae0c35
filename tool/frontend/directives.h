/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Preprocessing lines of a source file: libclang shows pragmas and untaken branches only in
 *  part. */
#ifndef FRONTEND_DIRECTIVES_H
#define FRONTEND_DIRECTIVES_H

#include "ir/ir.h"

/** All directives and _Pragma operators of the text, including untaken branches, in order, into
 *  unit->directives. Handles line splices, comments, strings, digraphs and trigraphs. */
void find_directives(arena *a, ir_unit *unit);
/** The same for any text; ranges are offsets in it. */
ir_directive *directives_in(arena *a, const char *text, size_t length, unsigned *count);

/** The number of bytes of the backslash and line end at `p`; 0: there is none. */
unsigned splice_length(const char *p, const char *end);
/** The end of the comment, string, character constant or splice that begins at `at`, before `end`;
 *  else the next byte. Thread-safe. */
const char *piece_end(const char *at, const char *end);

#endif
