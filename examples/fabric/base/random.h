/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Pseudo-random numbers that are the same on every machine: splitmix64 (Steele, Lea and Flood,
 * Fast splittable pseudorandom number generators, OOPSLA 2014). Not cryptographic. */
#ifndef FABRIC_RANDOM_H
#define FABRIC_RANDOM_H

#include <assert.h>
#include <stdint.h>

/** The generator's whole state; any value is a good seed. */
typedef struct random_source {
    uint64_t state;
} random_source;

static inline uint64_t random_bits(random_source *source) {
    uint64_t z = (source->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/** Returns a number uniform in [-1, 1). */
static inline double random_signed(random_source *source) {
    return (double)(random_bits(source) >> 11) * 0x1p-52 - 1.0;
}

/** Returns a number uniform in 0 .. count - 1 (count > 0). Its bias of 2^-32 * count is negligible
 *  here. */
static inline int random_below(random_source *source, int count) {
    assert(count > 0);
    return (int)(((random_bits(source) >> 32) * (uint64_t)count) >> 32);
}

#endif
