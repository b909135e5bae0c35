/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// DIRECTLY: 1 2 3 16 33
// Iterations that update no element of the array, but store to their own element: every method executes them.
// METHODS: dwa-lip dwa-lip-fixed pe-dwa-lip expansion expansion-fixed pseudo-expansion
#include "case.h"

enum { N = 3000, M = 400 };
static long own[N];
static int key[N], h[M];

static void halve(int n, const int *k, long *mine, int *b) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        int v = (int)mine[i];
        mine[i] = v / 2 + 1;
        if (k[i] % 3 == 0)
            continue;
        b[k[i]] += v;
    }
}

/* No update can change a subscript. */
static void halve_apart(int n, const int *restrict k, long *restrict mine, int *restrict b) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        int v = (int)mine[i];
        mine[i] = v / 2 + 1;
        if (k[i] % 3 == 0)
            continue;
        b[k[i]] += v;
    }
}

/* The iterations of the second half update nothing. */
static void first_half(int n, const int *k, long *mine, int *b) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        if (mine[i] > 5)
            mine[i] -= 3;
        if (i < n / 2)
            b[k[i]] += k[i];
    }
}

int main(void) {
    for (int i = 0; i < N; i++) {
        own[i] = i % 1009 + 7;
        key[i] = i * 7919 % M;
    }
    for (int call = 0; call < 3; call++) {
        halve(N, key, own, h);
        first_half(N, key, own, h);
        key[call] = call;
        case_print("own", own, sizeof own);
        case_print("h", h, sizeof h);
    }
    for (int i = 0; i < N; i++) /* most blocks of iterations update only h[1] */
        key[i] = i < N - 500 ? i % 2 : i * M / N;
    for (int call = 0; call < 3; call++)
        halve_apart(N, key, own, h);
    CASE_PRINT(own);
    CASE_PRINT(h);
    return 0;
}
