/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The macros that a compiler defines by itself, in the place of the parser's own. */
#ifndef FRONTEND_PREDEFINED_H
#define FRONTEND_PREDEFINED_H

#include "frontend/flags.h"

/** Flags, as items of an array, without which clang would not be taken for gcc. By these names it
 * is known: */
#define FLAGS_WITHOUT_CLANG                                                                        \
    "-U__clang__", "-U__clang_major__", "-U__clang_minor__", "-U__clang_patchlevel__",             \
        "-U__clang_version__", "-U__llvm__"
/** gcc's headers use types for which it has no names: */
#define FLAGS_OF_GCC_TYPES                                                                         \
    "-D_Float32=float", "-D_Float64=double", "-D_Float32x=double", "-D_Float64x=long double",      \
        "-D_Float128=__float128"
/** these operators of #if gcc 12 does not know. */
#define FLAGS_WITHOUT_FEATURES "-D__has_feature(x)=0", "-D__has_extension(x)=0"

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
