/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Updates of objects without a name: parts of complex numbers or vectors, compound literals, elements selected by GNU C
// expressions. They are not analysed, but their loops are reported.
#include <complex.h>

typedef int vector __attribute__((vector_size(16)));

void parts(int n, const int *k, double complex *z) {
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        __real__ z[k[t]] += 1;
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        (__imag__ z[k[t]])--;
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        __imag__ z[k[t]] = __imag__ z[k[t]] + t;
    for (int t = 0; t < n; t++) { // EXPECT: refuse opaque
        double complex *const at = &z[k[t]];
        __real__ *at *= 2;
    }
}

struct wave {
    double complex z[2];
    vector v;
};

void members(int n, const int *k, struct wave *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        __real__ w[k[t]].z[1] += 1;
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        w[k[t]].v[1] |= 1;
}

/* The updated parts are private to the iteration. */
void own_parts(int n, const int *k, double complex *z, vector *v) {
    for (int t = 0; t < n; t++) { // EXPECT: unlisted
        double complex here[4] = {0};
        vector there[4] = {0};
        __real__ here[k[t]] += 1;
        there[k[t]][0] += 1;
        __real__ z[t] += here[0];
        v[t][t & 3] += there[0][0];
    }
}

void literals(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse base-varies
        (int){0}++;
        h[k[t]]++;
    }
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        (int){k[t]} += 3;
}

void chosen(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        _Generic(0, int: h[k[t]]) += 3;
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        __builtin_choose_expr(1, h[k[t]], h)++;
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        (*({ h + k[t]; })) += 3;
}

void vectors(int n, const int *k, vector *v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        v[k[t]][t & 3] += 3;
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        ++v[k[t]][1];
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        v[k[t]][2] = 2 * v[k[t]][2] + 3;
}
