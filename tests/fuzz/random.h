/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Random numbers determined by a seed (splitmix64). */
#ifndef FUZZ_RANDOM_H
#define FUZZ_RANDOM_H

#include <stdbool.h>
#include <stdint.h>

typedef struct random_source {
    uint64_t state;
} random_source;

static inline uint64_t random_next(random_source *r) {
    uint64_t z = (r->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/** Returns a number in 0 ... n - 1; n must be positive. */
static inline int random_below(random_source *r, int n) {
    return (int)(random_next(r) % (uint64_t)n);
}

static inline bool random_chance(random_source *r, int percent) {
    return random_below(r, 100) < percent;
}

#endif
