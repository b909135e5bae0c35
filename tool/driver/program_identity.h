/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which programs answer: by the contents of their files, never by a date or a version they tell.
 */
#ifndef DRIVER_PROGRAM_IDENTITY_H
#define DRIVER_PROGRAM_IDENTITY_H

#include "driver/store.h"
#include "driver/words.h"

/** Adds the contents of files. They are taken from the store where the same files (device, inode,
 *  size, both times to the nanosecond) were read before. False where one cannot be read. */
bool identity_add_files(arena *a, const store *s, digester *d, const word_list *paths);

/** Adds the program that `name` starts, as PATH has it; of a launcher's link named after a compiler
 *  (ccache) also what it starts. False for a script, whose answers are anybody's guess. */
bool identity_add_program(arena *a, const store *s, digester *d, const char *name);

/** Adds the variables of the environment that a preprocessor, a linker's loader or redcc reads. */
void identity_add_environment(arena *a, digester *d);

#endif
