/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_ESCAPES_H
#define REDCC_ESCAPES_H

#include <stdbool.h>

/** May a handler of a signal, or a cancellation, leave the function that it interrupts, or take it
 * to another process? False only if no object of the process refers to a function by which that is
 * done, nor to one by which more objects or functions could be found. The answer of the first call
 * holds for good. */
bool redcc_may_escape(void);

/** Has the program a free of its own, and takes aligned memory from the library? gcc's OpenMP gives
 * back by the one what it took by the other, when a region has other threads than the last, or one.
 * The answer of the first call holds for good. */
bool redcc_allocator_is_split(void);

#endif
