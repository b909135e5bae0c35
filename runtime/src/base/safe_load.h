/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Pointers are read before a loop that the program may read under conditions only. */
#ifndef REDCC_SAFE_LOAD_H
#define REDCC_SAFE_LOAD_H

#include "redcc/structures.h"

#include <stdbool.h>

/** Is the last time, kept in *last, so long ago that some system calls do not count? */
bool redcc_is_time_to_load(redcc_word *last);

/** Copies `bytes` bytes from `from`: 1. 0: they cannot be read, or the system does not tell. Never
 * a fault, a signal, or a read of what a device has mapped. */
int redcc_load(void *to, const char *from, redcc_size bytes);

#endif
