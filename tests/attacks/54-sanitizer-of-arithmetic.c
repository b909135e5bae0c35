/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fsanitize=undefined -fno-sanitize-recover=all
// METHODS: auto localwrite binning expansion
// Partial sums in another order than the program's would overflow. So would computations on values that
// are read before they are final.
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N], low[K], more[N];
static long both[K + N], sum[K];

static void copies(int n, const int *restrict at, const int *restrict x) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        low[at[t]] += 51000000 + x[t];
}

static void stale(int n, const int *at, const long *w, long *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += 1 << (w[t] % 64);
}

int main(void) {
    for (int round = 0; round < 3; round++) {
        for (int t = 0; t < N; t++) {
            k[t] = t / 84;
            more[t] = t % 7;
        }
        for (int i = 0; i < K; i++)
            low[i] = -2147483647;
        copies(N, k, more);
        /* the shift by both[200] is defined only after the first iteration has added to it */
        for (int i = 0; i < N; i++) {
            k[i] = i == 0 ? 200 : K - 1;
            both[i] = i == 0 ? 2 : i == 200 ? 60 : i % 20;
        }
        stale(N - K, k, both, both);
        for (int i = 0; i < K; i++)
            sum[i] = low[i] * 3L + both[i];
    }
    for (int i = 0; i < K; i++)
        printf("%ld\n", sum[i]);
    return 0;
}
