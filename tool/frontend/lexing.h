/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Text that compilers read otherwise than the scanners of this tool do. */
#ifndef LEXING_H
#define LEXING_H

#include <stdbool.h>
#include <stddef.h>

/**
 * The first thing in a file's text that a compiler may read otherwise than directives.h and
 * support/source.h do: a raw string, which GNU's C has and ISO's has not; a trigraph for a
 * backslash, which is the other way round; blanks between a backslash and the line's end; _Pragma,
 * what begins a raw string, or a mark of comments, in two lines. In comments and strings too: where
 * those end is what is in doubt. NULL: nothing is. A static string; thread-safe.
 */
const char *lexing_in_doubt(const char *text, size_t length);

/** Does a quote stand between digits, as C23 has it and no C before? Thread-safe. */
bool lexing_has_digit_separator(const char *text, size_t length);

#endif
