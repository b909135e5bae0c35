/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// With -fPIC a program may define a function that the shared object exports, and so replace it.
// FLAGS: -fPIC
double half(double v) {
    return v * 0.5;
}

void replaced(int n, const int *restrict s, double *restrict h, const double *restrict e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse interposed
        h[s[t]] += half(e[t]);
}

double *place(double *h, int k) {
    return &h[k];
}

void replaced_place(int n, const int *restrict s, double *restrict h, const double *restrict e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse interposed
        *place(h, s[t]) += e[t];
}
