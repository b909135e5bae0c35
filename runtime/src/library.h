/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The table of functions through which compiled loops call the runtime (redcc/structures.h). */
#ifndef REDCC_LIBRARY_H
#define REDCC_LIBRARY_H

#include "redcc/structures.h"

extern const redcc_calls redcc_library;

#endif
