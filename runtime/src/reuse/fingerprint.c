/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "reuse/fingerprint.h"

#include "base/spin.h"
#include "reuse/fingerprint_wide.h"

#include <assert.h>
#include <string.h>

enum { LANES = 8, STRIPE = LANES * 8 };

/* Odd constants with well-mixed bits: from the golden ratio, and primes of xxHash. */
#define FIRST 0x9e3779b97f4a7c15u
#define SECOND 0xc2b2ae3d27d4eb4fu
#define THIRD 0x165667b19e3779f9u

/* The secret key of this process, which forked children share. */
static uint64_t key[REDCC_WIDE_KEYS];

static void make_key(void) {
    static struct spin lock;
    static atomic_int made;
    if (atomic_load_explicit(&made, memory_order_acquire))
        return;
    redcc_spin_lock(&lock);
    if (!atomic_load(&made))
        redcc_system_secret(key, REDCC_WIDE_KEYS);
    atomic_store(&made, 1);
    redcc_spin_unlock(&lock);
}

static inline uint64_t rotate(uint64_t value, int bits) {
    return value << bits | value >> (64 - bits);
}

static inline uint64_t load(const char *data, int word) {
    uint64_t value;
    memcpy(&value, data + 8 * word, 8);
    return value;
}

/* Combines word i of the data with its lane. The lanes are independent, which keeps the multiplier
 * busy. The word enters its own lane through a multiplication and a rotation (a bijection, so that
 * no single change is lost). It also enters the neighbouring lane, by addition. So a change affects
 * two lanes of 64 bits. */
#define TAKE_IN(lane, data, i)                                                                     \
    lane = rotate((lane ^ load(data, i)) * FIRST, 32) + load(data, (i) ^ 1)

/* Hashes `stripes` stripes at `data` into `lane`. Inside, the lanes are separate variables, not an
 * array. Only then do compilers keep them in registers at -O2, which is three times as fast. */
static void take_in(uint64_t lane[LANES], const char *data, size_t stripes) {
    uint64_t a = lane[0], b = lane[1], c = lane[2], d = lane[3];
    uint64_t e = lane[4], f = lane[5], g = lane[6], h = lane[7];
    for (size_t stripe = 0; stripe < stripes; stripe++, data += STRIPE) {
        TAKE_IN(a, data, 0);
        TAKE_IN(b, data, 1);
        TAKE_IN(c, data, 2);
        TAKE_IN(d, data, 3);
        TAKE_IN(e, data, 4);
        TAKE_IN(f, data, 5);
        TAKE_IN(g, data, 6);
        TAKE_IN(h, data, 7);
    }
    const uint64_t taken[LANES] = {a, b, c, d, e, f, g, h};
    memcpy(lane, taken, sizeof taken);
}

static uint64_t mix(uint64_t value) {
    value = (value ^ value >> 33) * SECOND;
    value = (value ^ value >> 29) * THIRD;
    return value ^ value >> 32;
}

/* Hashes all whole blocks by AVX2, if that is available. Returns the number of bytes hashed. */
static size_t take_in_blocks(uint64_t lane[LANES], const char *data, size_t bytes) {
    if (bytes < REDCC_WIDE_BLOCK || !redcc_has_wide())
        return 0;
    uint64_t wide[REDCC_WIDE_LANES];
    memcpy(wide, lane, LANES * sizeof *lane);
    memcpy(wide + LANES, lane, LANES * sizeof *lane);
    redcc_take_in_wide(wide, data, bytes / REDCC_WIDE_BLOCK, key);
    memcpy(lane, wide, LANES * sizeof *lane);
    take_in(lane, (const char *)(wide + LANES), 1);
    return bytes / REDCC_WIDE_BLOCK * REDCC_WIDE_BLOCK;
}

struct fingerprint redcc_fingerprint(const char *data, size_t bytes) {
    assert(data || bytes == 0);
    uint64_t lane[LANES];
    make_key();
    for (int i = 0; i < LANES; i++)
        lane[i] = key[i];
    size_t whole = take_in_blocks(lane, data, bytes);
    take_in(lane, data + whole, (bytes - whole) / STRIPE);
    whole += (bytes - whole) / STRIPE * STRIPE;
    char rest[STRIPE] = {0};
    if (bytes > whole)
        memcpy(rest, data + whole, bytes - whole);
    take_in(lane, rest, 1);
    struct fingerprint result = {{mix(bytes ^ key[LANES]), mix(bytes ^ key[LANES + 1])}};
    for (int i = 0; i < LANES; i++) {
        result.word[0] = mix(result.word[0] ^ lane[i]) + SECOND;
        result.word[1] = mix(result.word[1] * THIRD + rotate(lane[i], 17));
    }
    return result;
}

struct fingerprint redcc_fingerprint_join(const struct fingerprint *parts, int count) {
    assert(count >= 0);
    struct fingerprint result = {{FIRST, SECOND}};
    for (int i = 0; i < count; i++) {
        result.word[0] = mix(result.word[0] * FIRST + parts[i].word[0]);
        result.word[1] = mix(result.word[1] * THIRD + parts[i].word[1]);
    }
    return result;
}
