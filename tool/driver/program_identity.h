/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Identifies programs by the contents of their files, not by a date or a version. */
#ifndef DRIVER_PROGRAM_IDENTITY_H
#define DRIVER_PROGRAM_IDENTITY_H

#include "driver/store.h"
#include "driver/words.h"

/** Adds the contents of files to the digest. If the same files (device, inode, size, both times to
 * the nanosecond) were read before, their digests come from the store. Returns false if a file
 * cannot be read. */
bool identity_add_files(arena *a, const store *s, digester *d, const word_list *paths);

/** Adds the names, sizes and times of files to the digest. Returns false if one is no plain file,
 * or has changed so recently that it may change again without a new time. */
bool identity_add_times(digester *d, const word_list *paths);

/** Adds to the digest the program that `name` starts according to PATH. For a launcher's link named
 * after a compiler (ccache), also adds the program that it starts. Returns false for a script,
 * whose behaviour is unknown. */
bool identity_add_program(arena *a, const store *s, digester *d, const char *name);

/** Adds to the digest the environment variables that a preprocessor, the dynamic loader or redcc
 * reads. */
void identity_add_environment(arena *a, digester *d);

#endif
