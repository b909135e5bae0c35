/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reason R505: a function that does not compile is not analysed, but the next function is. */
void errors(int n, const int *s, double *h) {
    undeclared_type x;
    for (int i = 0; i < n; i++) // EXPECT: refuse errors
        h[s[i]] += 1.0;
}

void fine(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+)
        h[s[i]] += 1.0;
}
