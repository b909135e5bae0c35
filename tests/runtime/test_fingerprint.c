/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Fingerprints: every change of the bytes changes the fingerprint. */
#include "reuse/fingerprint.h"

#include <setjmp.h>
#include <stdarg.h>

#include <cmocka.h>

static void a_fingerprint_sees_every_bit(void **unused) {
    (void)unused;
    char data[3000] = {0};
    for (size_t bytes = 0; bytes <= sizeof data; bytes += bytes < 300 ? 37 : 900) {
        const struct fingerprint before = redcc_fingerprint(data, bytes);
        for (size_t bit = 0; bit < 8 * bytes; bit++) {
            data[bit / 8] = (char)(data[bit / 8] ^ (1 << bit % 8));
            const struct fingerprint after = redcc_fingerprint(data, bytes);
            assert_int_not_equal(before.word[0], after.word[0]);
            assert_int_not_equal(before.word[1], after.word[1]);
            data[bit / 8] = (char)(data[bit / 8] ^ (1 << bit % 8));
        }
    }
}

/* Flips the same bit in two words. A product alone would lose changes of the highest bit. */
static void a_fingerprint_sees_two_changes(void **unused) {
    (void)unused;
    enum { WORDS = 160 };
    unsigned long data[WORDS] = {0};
    const struct fingerprint before = redcc_fingerprint((char *)data, sizeof data);
    for (int bit = 0; bit < 64; bit += 9)
        for (int first = 0; first < WORDS; first++)
            for (int second = 0; second < first; second++) {
                data[first] ^= 1ul << bit;
                data[second] ^= 1ul << bit;
                assert_false(
                    redcc_fingerprint_equal(before, redcc_fingerprint((char *)data, sizeof data)));
                data[first] = data[second] = 0;
            }
}

/* Exchanges words, as when elements of a mesh are reordered. */
static void a_fingerprint_sees_what_changes_places(void **unused) {
    (void)unused;
    enum { EDGES = 300 };
    unsigned edge[EDGES][2];
    for (unsigned e = 0; e < EDGES; e++) {
        edge[e][0] = e / 2;
        edge[e][1] = e / 2 + 1 + e % 2 * 100;
    }
    const struct fingerprint before = redcc_fingerprint((char *)edge, sizeof edge);
    for (int e = 0; e < EDGES; e++)
        for (int other = 0; other < e; other++)
            for (int end = 0; end < 2; end++) {
                const unsigned value = edge[e][end];
                if (value == edge[other][end])
                    continue;
                edge[e][end] = edge[other][end];
                edge[other][end] = value;
                const struct fingerprint after = redcc_fingerprint((char *)edge, sizeof edge);
                assert_int_not_equal(before.word[0], after.word[0]);
                assert_int_not_equal(before.word[1], after.word[1]);
                edge[other][end] = edge[e][end];
                edge[e][end] = value;
            }
}

static unsigned long splitmix64(unsigned long *state) {
    unsigned long mixed = *state += 0x9e3779b97f4a7c15u;
    mixed = (mixed ^ mixed >> 30) * 0xbf58476d1ce4e5b9u;
    mixed = (mixed ^ mixed >> 27) * 0x94d049bb133111ebu;
    return mixed ^ mixed >> 31;
}

/* Contents constructed for a known key, the numbers of splitmix64 from 0. With that key all
 * products are 0 and only sums remain, so the upper halves of two words could be exchanged
 * unnoticed. */
static void a_fingerprint_has_a_secret(void **unused) {
    (void)unused;
    enum { STRIPES = 16, WORDS = 8 };
    unsigned long key[STRIPES + WORDS], state = 0, data[STRIPES][WORDS];
    for (int i = 0; i < STRIPES + WORDS; i++)
        key[i] = splitmix64(&state);
    for (int stripe = 0; stripe < STRIPES; stripe++)
        for (int word = 0; word < WORDS; word++)
            data[stripe][word] =
                (key[stripe + word] & 0xffffffffu) | (unsigned long)(stripe * WORDS + word) << 32;
    const struct fingerprint before = redcc_fingerprint((char *)data, sizeof data);
    const unsigned long difference = (data[0][0] ^ data[1][0]) & 0xffffffff00000000u;
    data[0][0] ^= difference;
    data[1][0] ^= difference;
    const struct fingerprint after = redcc_fingerprint((char *)data, sizeof data);
    assert_false(redcc_fingerprint_equal(before, after));
}

static void a_fingerprint_knows_lengths_and_places(void **unused) {
    (void)unused;
    char data[256] = {0};
    assert_false(
        redcc_fingerprint_equal(redcc_fingerprint(data, 64), redcc_fingerprint(data, 128)));
    assert_false(redcc_fingerprint_equal(redcc_fingerprint(data, 1), redcc_fingerprint(data, 2)));
    struct fingerprint parts[2] = {redcc_fingerprint("ab", 2), redcc_fingerprint("cd", 2)};
    const struct fingerprint whole = redcc_fingerprint_join(parts, 2);
    const struct fingerprint swap = parts[0];
    parts[0] = parts[1];
    parts[1] = swap;
    assert_false(redcc_fingerprint_equal(whole, redcc_fingerprint_join(parts, 2)));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fingerprint_sees_every_bit),
        cmocka_unit_test(a_fingerprint_sees_two_changes),
        cmocka_unit_test(a_fingerprint_sees_what_changes_places),
        cmocka_unit_test(a_fingerprint_has_a_secret),
        cmocka_unit_test(a_fingerprint_knows_lengths_and_places),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
