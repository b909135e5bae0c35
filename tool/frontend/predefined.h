/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Replaces the parser's predefined macros by those of the compiler that builds the program. */
#ifndef FRONTEND_PREDEFINED_H
#define FRONTEND_PREDEFINED_H

#include "frontend/flags.h"

/** Flags, as items of an array, that remove the names that identify clang, so that clang imitates
 *  gcc. */
#define FLAGS_WITHOUT_CLANG                                                                        \
    "-U__clang__", "-U__clang_major__", "-U__clang_minor__", "-U__clang_patchlevel__",             \
        "-U__clang_version__", "-U__llvm__"
/** Defines types that gcc's headers use and clang does not have. */
#define FLAGS_OF_GCC_TYPES                                                                         \
    "-D_Float32=float", "-D_Float64=double", "-D_Float32x=double", "-D_Float64x=long double",      \
        "-D_Float128=__float128"
/** Hides two operators of #if that gcc 12 does not have. */
#define FLAGS_WITHOUT_FEATURES "-D__has_feature(x)=0", "-D__has_extension(x)=0"

/** Adds flags that replace the parser's own macros by those in the file `path`, which is the output
 *  of `cc -dM -E -x c /dev/null`. Sets flags->predefined. If the file cannot be read, sets
 *  flags->unseen. */
void add_predefined(arena *a, parse_flags *flags, const char *path);

/** Removes from flags->predefined the macro that a user's flag redefines. `definition` is the flag,
 *  -DNAME=1 or -UNAME, with or without the -D or -U. */
void forget_predefined(parse_flags *flags, const char *definition);

/** Is the text an operator by which #if tests the compiler's features, such as `__has_builtin`? */
bool is_feature_test(const char *text, size_t length);

#endif
