/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Loops that differ in one point from loops whose trip count could be computed. */
#include <stddef.h>

void keep(int *p);
void done(void);
extern volatile int start;
int first(void);

void the_bounds_address(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse bound-varies
        const int *p = &n;
        h[s[i]] += *p;
    }
}

void down_instead_of_up(int n, const int *s, double *h) {
    for (int i = 0; i < n; i = i - 1) // EXPECT: refuse step
        h[s[i]] += 1.0;
}

void bound_by_counter(int n, const int *s, double *h) {
    for (int i = 0; i < n - i; i++) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void narrow_counter(int n, const int *s, double *h) {
    for (short i = 0; i < n; i++) // EXPECT: refuse counter-wraps
        h[s[i]] += 1.0;
}

void wider_bound(size_t n, const int *s, double *h) {
    for (unsigned i = 0; i < n; i++) // EXPECT: refuse counter-wraps
        h[s[i]] += 1.0;
}

void again_from_the_head(int n, int m, const int *s, double *h) {
    int i = 0;
    while (i < n) { // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
        if (s[i] > m)
            continue;
        i++;
    }
}

void first_value_with_effect(int n, const int *s, double *h) {
    for (int i = start; i < n; i++) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void first_value_by_a_call(int n, const int *s, double *h) {
    for (int i = first(); i < n; i++) // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
}

void last_value_by_address(int n, const int *s, double *h) {
    int k = 0;
    keep(&k);
    for (int i = 0; i < n; i++) { // EXPECT: refuse escapes
        k = s[i];
        h[k] += 1.0;
    }
    done();
}

unsigned sums_and_products(int n, int m, const int *s, double *h) {
    unsigned sum = 1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        for (int j = 0; j < m; j++) {
            sum += 3u;
            sum *= 5u;
        }
        h[s[i]] += 1.0;
    }
    return sum;
}
