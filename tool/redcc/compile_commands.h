/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compiler flags out of a compilation database (clang.llvm.org/docs/JSONCompilationDatabase.html).
 */
#ifndef COMPILE_COMMANDS_H
#define COMPILE_COMMANDS_H

#include "driver/words.h"
#include "redcc/options.h"

/** One that compiles a C file. */
typedef struct compile_command {
    const char *file, *directory; /**< as paths that hold from here; the directory as an absolute
                                     one where it is given as one */
    word_list words;              /**< the compiler, and what it is given */
} compile_command;

typedef VECTOR(compile_command) compile_command_list;

/** Appends to *flags those with which FOLDER/compile_commands.json compiles `input`; relative paths
 *  are made to hold from here. Returns NULL, or in the arena why it could not be done. */
const char *compile_commands_flags(arena *a, const char *folder, const char *input,
                                   string_list *flags);

/** Appends the commands by which FOLDER/compile_commands.json compiles C files (.c), in its order.
 * Returns NULL, or in the arena why it could not be done. */
const char *compile_commands_of_c(arena *a, const char *folder, compile_command_list *commands);

#endif
