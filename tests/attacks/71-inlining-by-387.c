/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// With -mfpmath=387 the bits depend on what gcc inlines. If one loop were translated and another
// refused, functions that both call would have one more caller. gcc would no longer inline them,
// and the refused loop would round differently. For comparison: 71-integers-by-387.c, a file
// without floating-point arithmetic.
// CFLAGS: -O1 -mfpmath=387
#include <stdio.h>

enum { N = 190, K = 173 };
struct place {
    int k, w;
};
static int subscript[N + 64];
static unsigned values[K], counts[K], own[N];

static unsigned half(int v) {
    return (unsigned)v / 2u;
}
static void find(const int *s, int t, int *k) {
    *k = s[t];
}
static int taken(const int *s, int t) {
    return s[t] / 2;
}
static struct place made(const int *s, int t) {
    const struct place p = {s[t], s[t + 1]};
    return p;
}

static double integers(int n, const int *restrict s, unsigned *restrict h, unsigned *restrict o,
                       const unsigned *restrict x) {
    unsigned sum = 7, count = 0, most = 1, last = 5;
    double real = 0.5;
    for (int t = 0; t < n; t++) { // EXPECT: refuse inexact-option
        struct place p;
        find(s, t, &p.k);
        p.w = s[t + 1];
        o[t] = o[t] * 3 + ((unsigned)taken(s, p.k));
        h[p.k] += half((int)x[p.k]);
    }
    return real + sum * 3.0 + count + most * 0.25 + last * 0.125;
}

static double more_integers(int n, const int *restrict s, unsigned *restrict h,
                            const unsigned *restrict x) {
    unsigned sum = 7, count = 0, most = 1, last = 5;
    double real = 0.5;
    for (int t = 0; t < n; t++) { // EXPECT: refuse inexact-option
        const struct place p = made(s, t);
        if (s[t + 3] & 2)
            h[p.k] += 3;
        if ((x[p.k] + 1u) & 1)
            count += ((half((int)x[p.k])) & 3) == 1;
    }
    return real + sum * 3.0 + count + most * 0.25 + last * 0.125;
}

static double rounded(int n, const int *restrict s, unsigned *restrict h, unsigned *restrict o,
                      const unsigned *restrict x) {
    unsigned sum = 7, count = 0, most = 1, last = 5;
    double real = 0.5;
    for (int t = 0; t < n; t++) { // EXPECT: refuse inexact-option
        const struct place p = made(s, t);
        if (s[t + 3] & 2)
            h[p.k] += 3;
        if (half((int)x[p.k]) & 1)
            real += 0.1 * ((unsigned)taken(s, p.k));
        o[t] = o[t] * 3 + (x[p.k] + 1u);
    }
    return real + sum * 3.0 + count + most * 0.25 + last * 0.125;
}

int main(void) {
    for (int i = 0; i < N + 64; i++)
        subscript[i] = (int)((i * 7919L + 13) % K);
    for (int i = 0; i < K; i++)
        values[i] = (unsigned)i * 2654435761u % 1000u;
    for (int round = 0; round < 3; round++) {
        printf("%a\n", integers(N, subscript, counts, own, values));
        printf("%a\n", more_integers(N, subscript, counts, values));
        printf("%a\n", more_integers(N - 1, subscript, counts, values));
        printf("%a\n", rounded(N, subscript, counts, own, values));
        printf("%a\n", rounded(N - round, subscript, counts, own, values));
    }
    for (int i = 0; i < K; i++)
        printf("%u %u\n", counts[i], own[i]);
    return 0;
}
