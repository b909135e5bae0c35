/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Division of iterations, or of items, into equal consecutive shares. */
#ifndef REDCC_SHARE_H
#define REDCC_SHARE_H

#include "redcc/runtime.h"

#include <stdint.h>

static inline redcc_int redcc_min(redcc_int a, redcc_int b) {
    return a < b ? a : b;
}

static inline redcc_int redcc_max(redcc_int a, redcc_int b) {
    return a > b ? a : b;
}

/** The first iteration of share number `thread` when iterations are divided into `threads` equal
 * shares; `trip` if thread == threads. Each thread inspects its share. With methods that divide
 * iterations evenly, it also executes it. */
static inline redcc_int redcc_share(redcc_int trip, int threads, int thread) {
    const redcc_int quotient = trip / threads, rest = trip % threads;
    return quotient * thread + (thread < rest ? thread : rest);
}

/** The first item of part `part` when `count` items are divided into `parts` consecutive equal
 * parts; `count` if part == parts. */
static inline uint32_t redcc_part_first(uint32_t count, int parts, int part) {
    return (uint32_t)((uint64_t)count * (uint64_t)part / (uint64_t)parts);
}

#endif
