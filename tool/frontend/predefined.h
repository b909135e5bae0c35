/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The macros that a compiler defines by itself, in the place of the parser's own. */
#ifndef FRONTEND_PREDEFINED_H
#define FRONTEND_PREDEFINED_H

#include "frontend/flags.h"

/** Adds flags that make the parser's own macros those in the file `path`, which is what
 *  `cc -dM -E -x c /dev/null` prints, and sets flags->predefined. Where it cannot be read
 *  it is flags->unseen. */
void add_predefined(arena *a, parse_flags *flags, const char *path);

/** Takes from flags->predefined what a flag of the user's, `-DNAME=1` or `-UNAME` with or without
 *  its first two bytes, defines otherwise. */
void forget_predefined(parse_flags *flags, const char *definition);

/** Is the text one of the operators by which #if asks what the compiler can do (`__has_builtin`)?
 */
bool is_compiler_question(const char *text, size_t length);

#endif
