/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions of the C library that compute a value and touch nothing else. */
#ifndef ANALYSIS_LIBRARY_H
#define ANALYSIS_LIBRARY_H

#include <stdbool.h>

typedef struct library_function {
    const char *name;
    bool sets_errno; /* where it fails */
    bool is_exact;   /* one result is right, and all implementations give it: no approximation */
} library_function;

/** By name, with or without __builtin_ before it, or the suffix f or l of <math.h>; NULL: another.
 */
const library_function *library_find(const char *name);

#endif
