/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/digest.h"

#include <assert.h>
#include <endian.h>
#include <string.h>

static const uint64_t initial[8] = {0x6a09e667f3bcc908, 0xbb67ae8584caa73b, 0x3c6ef372fe94f82b,
                                    0xa54ff53a5f1d36f1, 0x510e527fade682d1, 0x9b05688c2b3e6c1f,
                                    0x1f83d9abfb41bd6b, 0x5be0cd19137e2179};

static const unsigned char order[10][16] = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
                                            {14, 10, 4, 8, 9, 15, 13, 6, 1, 12, 0, 2, 11, 7, 5, 3},
                                            {11, 8, 12, 0, 5, 2, 15, 13, 10, 14, 3, 6, 7, 1, 9, 4},
                                            {7, 9, 3, 1, 13, 12, 11, 14, 2, 6, 5, 10, 4, 0, 15, 8},
                                            {9, 0, 5, 7, 2, 4, 10, 15, 14, 1, 11, 12, 6, 8, 3, 13},
                                            {2, 12, 6, 10, 0, 11, 8, 3, 4, 13, 7, 5, 15, 14, 1, 9},
                                            {12, 5, 1, 15, 14, 13, 4, 10, 0, 7, 6, 3, 9, 2, 8, 11},
                                            {13, 11, 7, 14, 12, 1, 3, 9, 5, 0, 15, 4, 8, 6, 2, 10},
                                            {6, 15, 14, 9, 11, 3, 0, 8, 12, 2, 13, 7, 1, 4, 10, 5},
                                            {10, 2, 8, 4, 7, 6, 1, 5, 15, 11, 9, 14, 3, 12, 13, 0}};

static uint64_t turned(uint64_t word, unsigned by) {
    return word >> by | word << (64 - by);
}

/* Inlined into unrolled rounds, so that every index is a constant and `v` stays in registers. The
 * rounds then have a third of the instructions. */
__attribute__((always_inline)) static inline void
mix(uint64_t *v, unsigned a, unsigned b, unsigned c, unsigned d, uint64_t x, uint64_t y) {
    v[a] += v[b] + x;
    v[d] = turned(v[d] ^ v[a], 32);
    v[c] += v[d];
    v[b] = turned(v[b] ^ v[c], 24);
    v[a] += v[b] + y;
    v[d] = turned(v[d] ^ v[a], 16);
    v[c] += v[d];
    v[b] = turned(v[b] ^ v[c], 63);
}

static void compress(digester *d, const unsigned char *block, uint64_t is_last) {
    uint64_t v[16], m[16];
    static_assert(sizeof m == sizeof d->block, "a block is 16 words");
    memcpy(m, block, sizeof m);
    for (unsigned i = 0; i < 16; i++)
        m[i] = le64toh(m[i]);
    for (unsigned i = 0; i < 8; i++) {
        v[i] = d->state[i];
        v[i + 8] = initial[i];
    }
    v[12] ^= d->length;
    v[14] ^= 0 - is_last;
#pragma GCC unroll 12
    for (unsigned round = 0; round < 12; round++) {
        const unsigned char *s = order[round % 10];
#pragma GCC unroll 4
        for (unsigned i = 0; i < 4; i++)
            mix(v, i, 4 + i, 8 + i, 12 + i, m[s[2 * i]], m[s[2 * i + 1]]);
#pragma GCC unroll 4
        for (unsigned i = 0; i < 4; i++)
            mix(v, i, 4 + (i + 1) % 4, 8 + (i + 2) % 4, 12 + (i + 3) % 4, m[s[8 + 2 * i]],
                m[s[9 + 2 * i]]);
    }
    for (unsigned i = 0; i < 8; i++)
        d->state[i] ^= v[i] ^ v[i + 8];
}

digester digest_begin(void) {
    digester d;
    memset(&d, 0, sizeof d);
    memcpy(d.state, initial, sizeof initial);
    d.state[0] ^= 0x01010000 ^ sizeof(digest);
    return d;
}

void digest_add(digester *d, const void *bytes, size_t count) {
    const unsigned char *at = bytes;
    assert(bytes || count == 0);
    assert(d->filled <= sizeof d->block);
    while (count > 0) {
        if (d->filled == sizeof d->block) { /* the last block is compressed only at the end */
            d->length += d->filled;
            compress(d, d->block, 0);
            d->filled = 0;
        }
        const size_t room = sizeof d->block - d->filled, some = count < room ? count : room;
        memcpy(d->block + d->filled, at, some);
        d->filled += (unsigned)some;
        at += some;
        count -= some;
    }
}

void digest_text(digester *d, const char *text) {
    const unsigned char is_there = text != NULL;
    digest_add(d, &is_there, 1);
    if (text)
        digest_add(d, text, strlen(text) + 1);
}

digest digest_end(digester *d) {
    assert(d->filled <= sizeof d->block);
    digest made;
    d->length += d->filled;
    memset(d->block + d->filled, 0, sizeof d->block - d->filled);
    compress(d, d->block, 1);
    for (unsigned i = 0; i < sizeof made.bytes; i++)
        made.bytes[i] = (unsigned char)(d->state[i / 8] >> 8 * (i % 8));
    return made;
}
