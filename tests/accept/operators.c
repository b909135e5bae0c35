/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Updates by *, &, | and ^.
// covers: row 38, row 27 of docs/constructs.md
#include "case.h"

enum { N = 20000, M = 1200 };
static int s[N];
static double v[N], product[M];
static unsigned set[M], kept[M], flipped[M];

static void multiply(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        product[s[t]] *= 1.0 + 0.125 * v[t];
}

static void bits(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        set[s[t]] |= 1u << (t % 32);
        kept[s[t]] &= ~(1u << (t % 29));
        flipped[s[t]] ^= (unsigned)t * 2654435761u;
    }
}

int main(void) {
    for (int i = 0; i < M; i++) {
        product[i] = 1.0;
        kept[i] = ~0u;
    }
    case_values(v, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        if (getenv("CASE_INTEGERS") == NULL)
            multiply(N);
        bits(N);
        CASE_PRINT(product);
        CASE_PRINT(set);
        CASE_PRINT(kept);
        CASE_PRINT(flipped);
    }
    return 0;
}
