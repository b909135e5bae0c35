/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* With -ffast-math two copies of a text may round differently, even one text whose calls are
 * inlined differently. So redcc refuses all loops of a file with floating-point arithmetic. */
// covers: row 33 of docs/constructs.md
// FLAGS: -ffast-math
double sum;

void sums(int n, const int *restrict s, double *restrict h, const double *restrict e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse inexact-option
        h[s[t]] += e[t];
}

void in_subscripts(int n, int *restrict h, const double *restrict e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse inexact-option
        h[(int)(e[t] * 10.0)]++;
}

static double half(double v) {
    return v * 0.5;
}
void in_callees(int n, const int *restrict s, double *restrict h, const double *restrict e) {
    for (int t = 0; t < n; t++) // EXPECT: refuse inexact-option
        h[s[t]] -= half(e[t]);
}

void beside(int n, const int *restrict s, int *restrict h, const double *restrict e) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse inexact-option
        h[s[t]]++;
        sum += e[t];
    }
}

void integers(int n, const int *restrict s, int *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse inexact-option
        h[s[t]]++;
}
