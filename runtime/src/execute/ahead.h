/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** For compiled executors (redcc/prefetch.h): finds the iterations to prefetch, and the rows that
 * they read. */
#ifndef REDCC_EXECUTE_AHEAD_H
#define REDCC_EXECUTE_AHEAD_H

#include "redcc/structures.h"

extern const redcc_ahead_calls redcc_ahead_library;

#endif
