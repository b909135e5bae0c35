/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions named like one of the C library or of this file, but renamed to others by asm labels or pragmas.
// covers: row 14, row 17 of docs/constructs.md
// FLAGS: -w
extern double sin(double) __asm__("counts_its_calls");
#pragma redefine_extname cos counts_its_calls
extern double cos(double);
extern void *memcpy(void *, const void *, unsigned long) __asm__("copies_more");

int calls;
double counts_its_calls(double x) {
    return x + ++calls;
}
double fabs(double) __attribute__((alias("counts_its_calls")));
static double own(double) __attribute__((alias("counts_its_calls")));

void by_label(int n, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[k[t]] += sin(t);
}

void by_pragma(int n, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[k[t]] += cos(t);
}

void by_attribute(int n, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[k[t]] += fabs(t);
}

void by_attribute_in_file(int n, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[k[t]] += own(t);
}

void copied(int n, const int *k, const double *restrict e, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        double x;
        memcpy(&x, &e[t], sizeof x);
        h[k[t]] += x;
    }
}
