/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Updates of what has no name: parts of complex numbers, of vectors, compound literals, elements that GNU C's expressions
// choose. They are not analysed.
#include <complex.h>

typedef int vector __attribute__((vector_size(16)));

void parts(int n, const int *k, double complex *z) {
    for (int t = 0; t < n; t++)
        __real__ z[k[t]] += 1;
}

void literals(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse base-varies
        (int){0}++;
        h[k[t]]++;
    }
    for (int t = 0; t < n; t++)
        (int){k[t]} += 3;
}

void chosen(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++)
        _Generic(0, int: h[k[t]]) += 3;
    for (int t = 0; t < n; t++)
        __builtin_choose_expr(1, h[k[t]], h)++;
    for (int t = 0; t < n; t++)
        (*({ h + k[t]; })) += 3;
}

void vectors(int n, const int *k, vector *v) {
    for (int t = 0; t < n; t++)
        v[k[t]][t & 3] += 3;
}
