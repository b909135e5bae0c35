/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A compiler's answer to __has_builtin decides the type.
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
