/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Lists functions of the C library that have side effects, whatever the user's pragmas state. */
#ifndef ANALYSIS_STATEFUL_H
#define ANALYSIS_STATEFUL_H

#include <stdbool.h>

/** The effect of a library function of this name, as a verb with its object, such as "writes
 *  output". NULL if the function is not known to print, read input, allocate, keep state, write
 *  memory or end the program. */
const char *stateful_effect(const char *name);

/** Is it a function that takes or releases a lock? */
bool stateful_is_lock(const char *name);

#endif
