/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Subscripts that the loop itself computes or changes, or that cannot be computed twice.
// covers: row 31, row 32, row 33, row 34 of docs/constructs.md
#include <math.h>

void written_subscripts(int n, int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        h[k[t]] += 1.0;
        k[t + 1] = k[t] + 1;
    }
}

void subscripts_updated(int n, int *k, const int *r, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        k[r[t]] += 1;
        h[k[t]] += 1.0;
    }
}

void moving_subscript(int n, const int *k, double *h) {
    int j = 0;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[(t & 1) && j++]] += 1.0;
}

void assigned_in_subscript(int n, const int *k, double *h) {
    int j = 0;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[j = k[t + j]] += 1.0;
}

