/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Processes made by fork, in which a parallel region may wait for threads that are not there. */
#ifndef REDCC_FORKED_H
#define REDCC_FORKED_H

#include <stdbool.h>

/** Had the process, or one it descends from, several threads when it forked? Only the one that
 * forked is in the child, while GCC's OpenMP goes on waiting for the others. Any thread may ask. */
bool redcc_is_forked(void);

#endif
