/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Updated elements of every arithmetic type.
// covers: row 39, row 40 of docs/constructs.md
#include "case.h"

enum { N = 12000, M = 700 };
static int s[N];
static double w[N];
static signed char c8[M];
static unsigned short u16[M];
static unsigned u32[M];
static long l64[M];
static float f32[M];

static void integers(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        c8[s[t]] += 1;
        u16[s[t]] -= 3;
        u32[s[t]] += (unsigned)t * 2654435761u;
        l64[s[t]] -= (long)t * t;
    }
}

static void products(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        u32[s[t]] *= 2u * (unsigned)t + 1u;
}

static void floating(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        f32[s[t]] += (float)(w[t] / 3.0);
}

int main(void) {
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        integers(N);
        products(N);
        if (getenv("CASE_INTEGERS") == NULL)
            floating(N);
        CASE_PRINT(c8);
        CASE_PRINT(u16);
        CASE_PRINT(u32);
        CASE_PRINT(l64);
        CASE_PRINT(f32);
    }
    return 0;
}
