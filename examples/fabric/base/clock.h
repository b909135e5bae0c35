/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Wall time. */
#ifndef FABRIC_CLOCK_H
#define FABRIC_CLOCK_H

#include <time.h>

/** Seconds since an unspecified moment; monotonic. */
static inline double clock_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#endif
