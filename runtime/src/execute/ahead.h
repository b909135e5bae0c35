/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Iterates over later iterations and their reads, for compiled executors (redcc/prefetch.h). */
#ifndef REDCC_EXECUTE_AHEAD_H
#define REDCC_EXECUTE_AHEAD_H

#include "redcc/structures.h"

extern const redcc_ahead_calls redcc_ahead_library;

#endif
