/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Products, minima, maxima, and, or, xor.
// covers: row 37, row 38, row 27
#include "case.h"

enum { N = 20000, M = 1200 };
static int s[N];
static double v[N], product[M], least[M], most[M], chosen[M];
static unsigned set[M], kept[M], flipped[M];

static void multiply(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        product[s[t]] *= 1.0 + 0.125 * v[t];
}

static void extremes(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (v[t] < least[s[t]])
            least[s[t]] = v[t];
        if (most[s[t]] < v[t])
            most[s[t]] = v[t];
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        chosen[s[t]] = chosen[s[t]] > v[t] ? chosen[s[t]] : v[t];
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
        extremes(N);
        bits(N);
        CASE_PRINT(product);
        CASE_PRINT(least);
        CASE_PRINT(most);
        CASE_PRINT(chosen);
        CASE_PRINT(set);
        CASE_PRINT(kept);
        CASE_PRINT(flipped);
    }
    return 0;
}
