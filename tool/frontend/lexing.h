/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Text that compilers may read differently than the scanners of this tool. */
#ifndef LEXING_H
#define LEXING_H

#include <stdbool.h>
#include <stddef.h>

/**
 * The first construct in a file's text that a compiler may read differently than directives.h and
 * support/source.h: a raw string (only GNU C has it); a trigraph for a backslash (only ISO C);
 * blanks between a backslash and the line's end; _Pragma, the beginning of a raw string, or a
 * comment's mark, split over two lines; pieces of _Pragma; #elifdef. Comments and strings are
 * searched, too, because compilers may disagree about where they end. NULL: none. A static string;
 * thread-safe.
 */
const char *lexing_in_doubt(const char *text, size_t length);

/** Is there a quote between digits, as C23 permits and no earlier C? Thread-safe. */
bool lexing_has_digit_separator(const char *text, size_t length);

#endif
