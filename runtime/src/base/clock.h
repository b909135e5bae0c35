/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_CLOCK_H
#define REDCC_CLOCK_H

#include "base/system.h"

/** The time of a monotonic clock, in seconds. */
static inline double redcc_seconds(void) {
    const struct timespec now = redcc_system_clock(CLOCK_MONOTONIC);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

#endif
