/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds text that a compiler may read differently than redcc's scanners do. */
#ifndef LEXING_H
#define LEXING_H

#include <stdbool.h>
#include <stddef.h>

/** Returns the first construct in the text that a compiler may read differently than directives.h
 *  and support/source.h do; NULL if there is none. The constructs are
 *  - raw strings (only GNU C has them) and the trigraph for a backslash (only ISO C);
 *  - blanks between a backslash and the line's end;
 *  - _Pragma, the start of a raw string, or a comment's mark, when split over two lines;
 *  - pieces that a macro may paste to form _Pragma;
 *  - #elifdef and #elifndef.
 *
 *  Comments and strings are searched too, because compilers may disagree about where they end. The
 *  result is a static string. Thread-safe. */
const char *lexing_in_doubt(const char *text, size_t length);

/** Is there a quote between digits, which only C23 permits? Thread-safe. */
bool lexing_has_digit_separator(const char *text, size_t length);

#endif
