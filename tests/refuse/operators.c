/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Operators that are not accumulations, and two of them on one array.
// covers: row 23, row 27, row 22, row 37
#include <math.h>

void divided(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse operator
        h[k[t]] /= 2.0;
}

void remainder_of(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse operator
        h[k[t]] %= 7;
}

void shifted(int n, const int *k, unsigned *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse operator
        h[k[t]] <<= 1;
}

void shifted_back(int n, const int *k, unsigned *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse operator
        h[k[t]] >>= t & 3;
}

void two_operators(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse several-operators
        h[k[t]] += 1.0;
        h[k[t + 1]] *= 2.0;
    }
}

void two_operators_in_branches(int n, const int *k, unsigned *h, const int *which) {
    for (int t = 0; t < n; t++) // EXPECT: refuse several-operators
        if (which[t])
            h[k[t]] |= 1u;
        else
            h[k[t]] ^= 2u;
}

struct pair {
    double a, b;
};

void two_members(int n, const int *k, struct pair *p) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        p[k[t]].a += 1.0;
        p[k[t]].a *= 0.5;
    }
}

void minus_itself(int n, const int *k, double *h, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] = w[t] - h[k[t]];
}

void with_a_factor(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] = 0.5 * h[k[t]] + 1.0;
}

void twice(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] = h[k[t]] + h[k[t]];
}

void of_another(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] = h[k[t + 1]] + 1.0;
}

void applied(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] = sqrt(h[k[t]] + 1.0);
}

void least(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse min-max
        if (v[t] < h[k[t]])
            h[k[t]] = v[t];
}

void most(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse min-max
        h[k[t]] = h[k[t]] > v[t] ? h[k[t]] : v[t];
}

void place_of_most(int n, const int *k, double *h, int *at, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (v[t] > h[k[t]]) {
            h[k[t]] = v[t];
            at[k[t]] = t;
        }
}
