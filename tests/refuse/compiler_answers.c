/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A type depends on __has_builtin, whose result differs between compilers.
#if defined(__has_builtin)
#if __has_builtin(__builtin_assume)
typedef float element;
#endif
#endif
#if !defined(__has_builtin) || !__has_builtin(__builtin_assume)
typedef double element;
#endif

void kernel(int n, const int *restrict s, element *restrict h, const double *restrict e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse compiler
        h[s[t]] += e[t];
}
