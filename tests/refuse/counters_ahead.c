/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The header compares an expression of the counter, but the trip count does not follow from it. The
 * expression may wrap around or be converted, or it is not the counter plus a constant. */
// covers: row 8 of docs/constructs.md
// covers: row 10 of docs/constructs.md
#include <stddef.h>

void longer_steps(size_t n, const int *s, double *h) {
    for (size_t i = 0; i + 1 < n; i += 2) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void another_variable(int n, int k, const int *s, double *h) {
    for (int i = 0; i + k < n; i++) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void behind(unsigned n, const int *s, double *h) {
    for (unsigned i = 0; i - 1 < n; i++) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void twice(int n, const int *s, double *h) {
    for (int i = 0; 2 * i < n; i++) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void narrow(int n, const int *s, double *h) {
    for (short i = 0; i + 1 < n; i++) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void converted(size_t n, const int *s, double *h) {
    for (int i = 0; i + sizeof(int) < n; i++) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void not_equal(int n, const int *s, double *h) {
    for (int i = 0; i + 1 != n; i++) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void down(int n, const int *s, double *h) {
    for (int i = n; i + 1 > 4; i--) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void below_zero(int n, const int *s, double *h) {
    for (int i = 0; i + -3 < n; i++) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void at_the_end(int n, const int *s, double *h) {
    int i = 0;
    do { // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
        i++;
    } while (i + 1 < n);
}

void inclusive(unsigned n, const int *s, double *h) {
    for (unsigned i = 0; i + 1 <= n; i++) // EXPECT: refuse counter-wraps
        h[s[i]] += 1.0;
}
