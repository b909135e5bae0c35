/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "fingerprint.h"

#include <string.h>

enum { LANES = 8, STRIPE = LANES * 8 };

/* Odd, bits well mixed: the golden ratio's, and primes of xxHash. */
#define FIRST 0x9e3779b97f4a7c15u
#define SECOND 0xc2b2ae3d27d4eb4fu
#define THIRD 0x165667b19e3779f9u

static inline uint64_t rotate(uint64_t value, int bits) {
    return value << bits | value >> (64 - bits);
}

/* Independent lanes keep the multiplier busy. Each word enters its own lane through a
 * multiplication and a rotation (a bijection, so that no single change is lost), and its neighbour
 * by addition, so that a change shows in two lanes of 64 bits. */
static inline void take_in(uint64_t lane[LANES], const char *data) {
    uint64_t word[LANES];
    memcpy(word, data, STRIPE);
    for (int i = 0; i < LANES; i++)
        lane[i] = rotate((lane[i] ^ word[i]) * FIRST, 32) + word[i ^ 1];
}

static uint64_t mix(uint64_t value) {
    value = (value ^ value >> 33) * SECOND;
    value = (value ^ value >> 29) * THIRD;
    return value ^ value >> 32;
}

struct fingerprint redcc_fingerprint(const char *data, size_t bytes) {
    uint64_t lane[LANES];
    for (int i = 0; i < LANES; i++)
        lane[i] = mix(FIRST * (uint64_t)(i + 1));
    size_t at = 0;
    for (; bytes - at >= STRIPE; at += STRIPE)
        take_in(lane, data + at);
    char rest[STRIPE] = {0};
    if (bytes > at)
        memcpy(rest, data + at, bytes - at);
    take_in(lane, rest);
    struct fingerprint result = {{mix(bytes ^ FIRST), mix(bytes ^ SECOND)}};
    for (int i = 0; i < LANES; i++) {
        result.word[0] = mix(result.word[0] ^ lane[i]) + SECOND;
        result.word[1] = mix(result.word[1] * THIRD + rotate(lane[i], 17));
    }
    return result;
}

struct fingerprint redcc_fingerprint_join(const struct fingerprint *parts, int count) {
    struct fingerprint result = {{FIRST, SECOND}};
    for (int i = 0; i < count; i++) {
        result.word[0] = mix(result.word[0] * FIRST + parts[i].word[0]);
        result.word[1] = mix(result.word[1] * THIRD + parts[i].word[1]);
    }
    return result;
}
