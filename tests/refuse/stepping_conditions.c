/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/stepping_conditions.c: their conditions do
// not give the trip count.
// covers: row 86 of docs/constructs.md
#include <stddef.h>

enum { N = 4000 };
extern int s[N];
extern double e[N], h[N];

void steps_twice(int n) {
    for (int i = n; --i >= 0; i--) // EXPECT: refuse counter-modified
        h[s[i]] += e[i];
}

void steps_in_the_body(int n) {
    int i = n;
    while (i-- > 0) { // EXPECT: refuse counter-modified
        h[s[i]] += e[i];
        if (s[i] > 3)
            i--;
    }
}

void without_an_end(size_t n) {
    for (size_t i = n; --i >= 0;) // EXPECT: refuse counter-wraps
        h[s[i]] += e[i];
}

void unsigned_to_a_bound(unsigned n, unsigned low) {
    while (n-- > low) // EXPECT: refuse counter-wraps
        h[s[n]] += e[n];
}

void compared_as_unsigned(int n, unsigned low) {
    while (n-- > low) // EXPECT: refuse counter-wraps
        h[s[n]] += e[n];
}

void narrow(short n) {
    while (n-- > 0) // EXPECT: refuse counter-wraps
        h[s[n]] += e[n];
}

void away(int n, int m) {
    while (n-- < m) // EXPECT: refuse trip-count
        h[s[n]] += e[n];
}

void once_more(int n) {
    while (n-- >= 0) // EXPECT: refuse trip-count
        h[s[n + 1]] += e[n + 1];
}

void bound_goes_along(int n, int m) {
    for (; n-- > m; m++) // EXPECT: refuse bound-varies
        h[s[n]] += e[n];
}

void bound_in_the_body(int n, int m) {
    while (n-- > m) { // EXPECT: refuse bound-varies
        h[s[n]] += e[n];
        m = s[n];
    }
}

void both_step(int n) {
    int m = 0;
    while (n-- > m++) // EXPECT: refuse trip-count
        h[s[n]] += e[n];
}

void asks_more(int n) {
    while (n-- > 0 && s[n] > 3) // EXPECT: refuse trip-count
        h[s[n]] += e[n];
}

void does_more(int n) {
    for (int i = n; i-- > 0; h[0]++) // EXPECT: refuse scalar-carried
        h[s[i]] += e[i];
}

extern int shared;

void global(void) {
    while (shared--) // EXPECT: refuse counter-type
        h[s[shared]] += e[shared];
}

void step_by_pointer(int n) {
    int *p = &n;
    while (n--) { // EXPECT: refuse counter-modified
        h[s[n]] += e[n];
        *p -= 1;
    }
}
