/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// gcc defines _REENTRANT where OpenMP is on: the loop in parallel form would be another.
#ifdef _REENTRANT
#define AT(t) n - 1 - (t)
#else
#define AT(t) (t)
#endif

void kernel(int n, const int *restrict s, double *restrict h, const double *restrict e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse compiler
        h[s[AT(t)]] += e[t];
}
