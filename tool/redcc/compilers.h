/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A program may be other code for gcc than for clang, by which it is parsed. */
#ifndef COMPILERS_H
#define COMPILERS_H

#include "ir/ir.h"
#include "redcc/options.h"

/** Is the file the same program for gcc? Asked only where the unit names a compiler
 *  (unit->text.compiler_word): then the file is parsed again, with gcc's names for itself in place
 * of clang's, and must give the same tree. Without an answer (errors): no. */
bool compilers_agree(arena *a, const source *file, const string_list *flags, const ir_unit *unit);

#endif
