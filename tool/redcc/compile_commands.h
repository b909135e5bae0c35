/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compiler flags from a compilation database
 *  (clang.llvm.org/docs/JSONCompilationDatabase.html). */
#ifndef COMPILE_COMMANDS_H
#define COMPILE_COMMANDS_H

#include "driver/words.h"
#include "redcc/options.h"

/** A command that compiles a C file. */
typedef struct compile_command {
    const char *file, *directory; /**< valid from the current folder; the directory is absolute if
                                   * it is given so */
    word_list words;              /**< the compiler and its arguments */
} compile_command;

typedef VECTOR(compile_command) compile_command_list;

/** Appends to *flags those with which FOLDER/compile_commands.json compiles `input`; relative paths
 *  are adapted to the current folder. Returns NULL, or a message in the arena. */
const char *compile_commands_flags(arena *a, const char *folder, const char *input,
                                   string_list *flags);

/** Appends the commands by which FOLDER/compile_commands.json compiles C files (.c), in its order.
 *  Returns NULL, or a message in the arena. */
const char *compile_commands_of_c(arena *a, const char *folder, compile_command_list *commands);

#endif
