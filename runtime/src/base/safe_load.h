/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Loads pointers before a loop, although the program may read them only under conditions. */
#ifndef REDCC_SAFE_LOAD_H
#define REDCC_SAFE_LOAD_H

#include "redcc/structures.h"

#include <stdbool.h>

/** Was the last call with this `last` at least 60 microseconds ago? Then the cost of a system call
 * is negligible. *last is the time of that call; it is set to the time of this call. */
bool redcc_is_time_to_load(redcc_word *last);

/** Copies `bytes` bytes from `from` to `to` and returns 1. Returns 0 if the bytes are unreadable or
 * might be. Never causes a fault or a signal, and never reads device memory. */
int redcc_load(void *to, const char *from, redcc_size bytes);

#endif
