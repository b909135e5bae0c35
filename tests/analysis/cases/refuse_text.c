/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reasons R5xx. Covers rows 1 to 3, 55, 56, 61, 62 and 68 of docs/constructs.md. */
#define LOOP(i, n) for (int i = 0; i < n; i++)
#define ADD(h, k, v) (h)[k] += (v)

void macro_loop(int n, const int *s, double *h) {
    LOOP(i, n) // EXPECT: refuse in-macro
        h[s[i]] += 1.0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+)
        ADD(h, s[i], 1.0);
    }
}

void directive(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse directive-in-range
#define TWO 2.0
        h[s[i]] += TWO;
    }
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+)
#if 1
        h[s[i]] += 1.0;
#else
        h[s[i]] += 2.0;
#endif
    }
}

void openmp(int n, const int *s, double *h) {
#pragma omp parallel for
    for (int i = 0; i < n; i++) // EXPECT: transform h(+)
        h[s[i]] += 1.0;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+)
#pragma omp atomic
        h[s[i]] += 1.0;
    }
}

void opaque(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse opaque
        h[s[i]] += ({ int k = s[i]; k; });
    for (int i = 0; i < n; i++) { // EXPECT: refuse opaque
        __asm__ volatile("" ::: "memory");
        h[s[i]] += 1.0;
    }
}

void reserved(int n, const int *s, double *redcc__h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse name
        redcc__h[s[i]] += 1.0;
}
