/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compiler flags out of a compilation database (clang.llvm.org/docs/JSONCompilationDatabase.html).
 */
#ifndef COMPILE_COMMANDS_H
#define COMPILE_COMMANDS_H

#include "redcc/options.h"

/** Appends to *flags those with which FOLDER/compile_commands.json compiles `input`; relative paths
 *  are made to hold from here. Returns NULL, or in the arena why it could not be done. */
const char *compile_commands_flags(arena *a, const char *folder, const char *input,
                                   string_list *flags);

/** Appends the C files (.c) that FOLDER/compile_commands.json compiles, as paths that hold from
 * here, in its order, as often as they stand there. Returns NULL, or in the arena why it could not
 * be done. */
const char *compile_commands_files(arena *a, const char *folder, string_list *files);

#endif
