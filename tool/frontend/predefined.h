/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A compiler's predefined macros, in place of the parser's own. */
#ifndef FRONTEND_PREDEFINED_H
#define FRONTEND_PREDEFINED_H

#include "frontend/flags.h"

/** Flags (items of an array) that make clang pass for gcc. These remove the names that identify
 *  clang; */
#define FLAGS_WITHOUT_CLANG                                                                        \
    "-U__clang__", "-U__clang_major__", "-U__clang_minor__", "-U__clang_patchlevel__",             \
        "-U__clang_version__", "-U__llvm__"
/** these define types that gcc's headers use and clang has no names for; */
#define FLAGS_OF_GCC_TYPES                                                                         \
    "-D_Float32=float", "-D_Float64=double", "-D_Float32x=double", "-D_Float64x=long double",      \
        "-D_Float128=__float128"
/** and these hide operators of #if that gcc 12 does not have. */
#define FLAGS_WITHOUT_FEATURES "-D__has_feature(x)=0", "-D__has_extension(x)=0"

/** Adds flags that replace the parser's own macros by those in the file `path`, the output of `cc
 *  -dM -E -x c /dev/null`, and sets flags->predefined. If it cannot be read, sets flags->unseen. */
void add_predefined(arena *a, parse_flags *flags, const char *path);

/** Removes from flags->predefined the macro that a flag of the user's redefines: `-DNAME=1` or
 *  `-UNAME`, with or without its first two bytes. */
void forget_predefined(parse_flags *flags, const char *definition);

/** Is the text an operator by which #if tests the compiler's features (`__has_builtin`)? */
bool is_feature_test(const char *text, size_t length);

#endif
