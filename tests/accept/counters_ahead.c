/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The header compares the counter plus a constant with the bound: i + 1 < n. Bounds at or below 0, bounds
// below the constant or at the limits of their types, and first values beyond the bound.
// covers: row 8 of docs/constructs.md
// covers: row 10 of docs/constructs.md
#include "case.h"
#include <limits.h>
#include <stddef.h>

enum { N = 9000, M = 700 };
static int s[N + 8];
static double w[N + 8], h[M];
static unsigned pairs[26][26];

static size_t bigrams(const char *text, size_t length) {
    size_t i;
    for (i = 0; i + 1 < length; i++) { // EXPECT: transformed
        const int a = text[i] - 'a', b = text[i + 1] - 'a';
        if (a >= 0 && a < 26 && b >= 0 && b < 26)
            pairs[a][b]++;
    }
    return i;
}

static int differences(int from, int n) {
    int i = from;
    for (; i + 2 <= n; ++i) // EXPECT: transformed
        h[s[i]] += w[i + 2] - w[i];
    while (n > 3 + i) { // EXPECT: transformed
        h[s[i]] -= w[i];
        i++;
    }
    return i;
}

static unsigned natural(unsigned from, unsigned n) {
    unsigned i;
    for (i = from; i + 4u < n; i++) // EXPECT: transformed
        h[s[i]] += w[i + 4];
    return i;
}

/* If i + 4u wraps around at the first iteration, the original loop runs. */
static unsigned wrapped(unsigned from, unsigned n) {
    unsigned i;
    for (i = from; i + 4u < n; i++) // EXPECT: transformed
        h[s[i + 4u]] += w[i + 4u];
    return i;
}

static long wide(long from, unsigned short n) {
    long i = from;
    for (; i + 5L < n; i++) // EXPECT: transformed
        h[s[i]] -= w[i];
    return i;
}

int main(void) {
    static char text[N + 1];
    case_values(w, N + 8);
    for (int round = 0; round < 5; round++) {
        case_subscripts(s, N + 8, M);
        for (int i = 0; i < N; i++)
            text[i] = (char)('a' - 2 + case_below(30));
        printf("%zu %zu %zu %zu\n", bigrams(text, N - (size_t)round), bigrams(text, 0),
               bigrams(text, 1), bigrams(text, 2));
        printf("%d %d %d %d\n", differences(round, N), differences(0, 1), differences(7, 2),
               differences(INT_MAX - 3, -5));
        printf("%u %u %u %u %u\n", natural(0, N), natural(0, 3), natural(0, 4), natural(9, 2),
               natural(UINT_MAX - 8, 2));
        printf("%u %u %u\n", wrapped(0, N), wrapped(UINT_MAX - 2, N), wrapped(UINT_MAX - 3, N));
        printf("%ld %ld %ld\n", wide(0, N), wide(-3, 2), wide(LONG_MAX - 7, 40));
        CASE_PRINT(h);
        CASE_PRINT(pairs);
    }
    return 0;
}
