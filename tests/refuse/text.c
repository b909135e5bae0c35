/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Source text that prevents the rewriting.
// covers: row 1, row 55, row 56, row 61, row 62, row 65, row 68 of docs/constructs.md
#include <assert.h>
#include <fenv.h>

#define EACH(t, n) for (int t = 0; t < (n); t++)
#define COUNT(h, k, n)                                                                             \
    for (int t_ = 0; t_ < (n); t_++)                                                               \
    (h)[(k)[t_]] += 1

void whole_loop_in_macro(int n, const int *k, int *h) {
    COUNT(h, k, n); // EXPECT: nothing
}

void header_in_macro(int n, const int *k, int *h) {
    EACH(t, n) // EXPECT: nothing
        h[k[t]] += 1;
}

void pragma_above(int n, const int *k, double *h) {
#pragma omp parallel for
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] += 1.0;
}

void pragma_inside(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
#pragma omp atomic
        h[k[t]] += 1.0;
    }
}

void unrolled(int n, const int *k, double *h) {
#pragma GCC unroll 4
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] += 1.0;
}

void assembly(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        __asm__ volatile("" ::: "memory");
        h[k[t]] += 1.0;
    }
}

void statement_expression(int n, const int *k, double *h) {
    int last = 0;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] += ({
            const int before = last;
            last = k[t];
            before;
        });
}

void counting_macro(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse counter-macro
        h[k[t]] += __COUNTER__;
}

void reserved_name(int n, const int *k, double *h) {
    double redcc__b = 1.0;
    for (int t = 0; t < n; t++) // EXPECT: refuse name
        h[k[t]] += redcc__b;
}

void asserted(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        assert(k[t] >= 0);
        h[k[t]] += 1.0;
    }
}
