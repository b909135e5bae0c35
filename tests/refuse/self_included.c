/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A file that includes itself: one source text stands for several loops.
#ifndef TYPE
#define TYPE double
#define NAME add_double
#include "self_included.c"
#undef TYPE
#undef NAME
#define TYPE _Bool
#define NAME add_bool
#include "self_included.c"
void count(int n, const int *restrict s, int *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse self-included
        h[s[t]] += 1;
}
#else
void NAME(int n, const int *restrict s, TYPE *restrict b) {
    for (int t = 0; t < n; t++) // EXPECT: refuse self-included
        b[s[t]] += t % 7;
}
#endif
