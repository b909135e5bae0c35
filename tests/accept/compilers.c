/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The program tests which compiler is used, but means the same under all of them.
// covers: row 2 of docs/constructs.md
#include "case.h"
#include <string.h>

#if defined(__GNUC__) && __GNUC__ >= 5 && !defined(__clang__)
#define LIKELY(x) __builtin_expect(!!(x), 1)
#elif defined(__clang__)
#define LIKELY(x) __builtin_expect(!!(x), 1)
#else
#define LIKELY(x) (x)
#endif
#ifdef __has_attribute
#if __has_attribute(noinline)
#define APART __attribute__((noinline))
#endif
#endif
#ifndef APART
#define APART
#endif

enum { N = 20000, M = 1200 };
static int s[N];
static double v[N], h[M];

static void kernel(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += v[t];
}

static APART int count(void) {
    return LIKELY(M > 0) ? M : 0;
}

int main(void) {
    double *copy = malloc(sizeof(double) * (size_t)count());
    if (!copy)
        return 1;
    case_values(v, N);
    case_subscripts(s, N, M);
    kernel(N);
    memcpy(copy, h, sizeof h);
    kernel(N);
    CASE_PRINT(h);
    printf("%g\n", copy[0]);
    free(copy);
    return 0;
}
