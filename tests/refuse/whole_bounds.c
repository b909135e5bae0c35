/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Floating-point bounds that no integer can replace. */
// covers: row 8, row 9 of docs/constructs.md
static double h[100];

void not_whole(const int *k) {
    for (int i = 0; i < 99.5; i++) // EXPECT: refuse trip-count
        h[k[i]] += 1;
}

/* As a float 16777217 becomes 16777216, which is not less than the bound. */
void as_float(const int *k) {
    for (int i = 0; i < 16777216.f; i++) // EXPECT: refuse trip-count
        h[k[i]] += 1;
    for (int i = 0; i <= 16777216.f; i++) // EXPECT: refuse trip-count
        h[k[i]] += 1;
}

void as_double(const int *k) {
    for (long i = 0; i <= 9007199254740992.0; i++) // EXPECT: refuse trip-count
        h[k[i]] += 1;
}

/* Rounded to double the bound is 1. */
void as_long_double(const int *k) {
    for (int i = 0; i < 0.99999999999999999999L; i++) // EXPECT: refuse trip-count
        h[k[i]] += 1;
}

void beyond_the_type(const int *k) {
    for (int i = 0; i < 3e9; i++) // EXPECT: refuse trip-count
        h[k[i]] += 1;
    for (unsigned i = 0; i < 5e9; i++) // EXPECT: refuse trip-count
        h[k[i]] += 1;
}

void no_literal(const int *k, double n) {
    for (int i = 0; i < n; i++) // EXPECT: refuse trip-count
        h[k[i]] += 1;
}
