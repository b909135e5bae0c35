/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compiler flags from a compilation database
 *  (clang.llvm.org/docs/JSONCompilationDatabase.html). */
#ifndef COMPILE_COMMANDS_H
#define COMPILE_COMMANDS_H

#include "driver/words.h"
#include "redcc/options.h"

/** A command that compiles a C file. */
typedef struct compile_command {
    const char *file, *directory; /**< paths from the current folder, or absolute if the database
                                   * has absolute ones */
    word_list words;              /**< the compiler and its arguments */
} compile_command;

typedef VECTOR(compile_command) compile_command_list;

/** Appends to *flags the flags with which FOLDER/compile_commands.json compiles `input`; relative
 * paths are made relative to the current folder. Returns NULL, or a message in the arena. */
const char *compile_commands_flags(arena *a, const char *folder, const char *input,
                                   string_list *flags);

/** Appends the commands by which FOLDER/compile_commands.json compiles C files (.c), in its order.
 *  Returns NULL, or a message in the arena. */
const char *compile_commands_of_c(arena *a, const char *folder, compile_command_list *commands);

#endif
