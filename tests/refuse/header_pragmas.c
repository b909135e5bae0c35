/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Pragmas in a header of the program: each thread of the loop would use another array, and another
// definition may replace a function of this file. covers: row 13 of docs/constructs.md
// FLAGS: -w -fopenmp
#include "header_pragmas.h"

double maybe_other(double x) {
    return x;
}

void updated(int n, const int *k) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-local
        of_thread[k[t]] += 1;
}

void read_in_loop(int n, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-local
        h[k[t]] += of_thread[k[t]];
}

void called(int n, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[k[t]] += maybe_other(1);
}
