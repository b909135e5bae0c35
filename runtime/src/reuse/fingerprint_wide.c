/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "reuse/fingerprint_wide.h"

#if defined(__x86_64__)

#include "base/processor.h"

#include <immintrin.h>

enum { WORDS = 8, STRIPES = REDCC_WIDE_BLOCK / (8 * WORDS) };

bool redcc_has_wide(void) {
    return redcc_has_avx2();
}

#define WIDE __attribute__((target("avx2"))) static inline

WIDE __m256i four(const void *words) {
    return _mm256_loadu_si256(words);
}

WIDE __m256i upper(__m256i words) {
    return _mm256_srli_epi64(words, 32);
}

/* Swaps each word with its neighbour. */
WIDE __m256i other(__m256i words) {
    return _mm256_shuffle_epi32(words, 0x4e);
}

/* Mixes a lane by a bijection, so that no difference is lost. */
WIDE __m256i scramble(__m256i lane, const uint64_t *under) {
    const __m256i odd = _mm256_set1_epi64x(0x9e3779b1);
    const __m256i mixed =
        _mm256_xor_si256(_mm256_xor_si256(lane, _mm256_srli_epi64(lane, 47)), four(under));
    const __m256i high = _mm256_mul_epu32(upper(mixed), odd);
    return _mm256_add_epi64(_mm256_mul_epu32(mixed, odd), _mm256_slli_epi64(high, 32));
}

/* As in XXH3 (Y. Collet, xxHash's specification), each word is combined with the stripe's key, and
 * the product of the word's halves is added to a lane. The unchanged word is added to the
 * neighbouring word's lane, so that no single change is lost. Only the products detect that two
 * words were swapped. So each half is also multiplied by a half of another word. */
__attribute__((target("avx2"))) void redcc_take_in_wide(uint64_t lane[REDCC_WIDE_LANES],
                                                        const char *data, size_t blocks,
                                                        const uint64_t key[REDCC_WIDE_KEYS]) {
    __m256i a = four(lane), b = four(lane + 4), c = four(lane + 8), d = four(lane + 12);
    for (size_t block = 0; block < blocks; block++) {
        for (int stripe = 0; stripe < STRIPES; stripe++, data += 8 * WORDS) {
            const __m256i low = four(data), high = four(data + 32);
            const __m256i x = _mm256_xor_si256(low, four(key + stripe));
            const __m256i y = _mm256_xor_si256(high, four(key + stripe + 4));
            a = _mm256_add_epi64(a, _mm256_add_epi64(_mm256_mul_epu32(x, upper(x)), other(low)));
            b = _mm256_add_epi64(b, _mm256_add_epi64(_mm256_mul_epu32(y, upper(y)), other(high)));
            c = _mm256_add_epi64(c, _mm256_mul_epu32(x, upper(y)));
            d = _mm256_add_epi64(d, _mm256_mul_epu32(y, upper(x)));
        }
        a = scramble(a, key);
        b = scramble(b, key + 4);
        c = scramble(c, key + 8);
        d = scramble(d, key + 12);
    }
    _mm256_storeu_si256((void *)lane, a);
    _mm256_storeu_si256((void *)(lane + 4), b);
    _mm256_storeu_si256((void *)(lane + 8), c);
    _mm256_storeu_si256((void *)(lane + 12), d);
}

#else

bool redcc_has_wide(void) {
    return false;
}

void redcc_take_in_wide(uint64_t lane[REDCC_WIDE_LANES], const char *data, size_t blocks,
                        const uint64_t key[REDCC_WIDE_KEYS]) {
    (void)key;
    (void)lane;
    (void)data;
    (void)blocks;
}

#endif
