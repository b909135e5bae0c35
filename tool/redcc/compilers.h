/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compares the program that gcc sees with the one that clang sees, whose parser redcc uses. */
#ifndef COMPILERS_H
#define COMPILERS_H

#include "ir/ir.h"
#include "redcc/options.h"

/** Is the file the same program for gcc? True if the unit names no compiler
 *  (unit->text.compiler_word). Otherwise the file is parsed again with gcc's predefined names
 *  instead of clang's, with and without clang's answers to feature tests. The result is true if
 *  both give the same tree without errors. */
bool compilers_agree(arena *a, const source *file, const string_list *flags, const ir_unit *unit);

#endif
