/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/step_statements.c: the trip count is not known
// before them, or iterations use the counter before and after its step.
// covers: rows 7, 86 and 91 of docs/constructs.md
#include <stddef.h>

enum { N = 4000 };
extern int s[N];
extern double e[N], h[N];

void uses_the_counter_before(int k) {
    while (k > 0) { // EXPECT: refuse trip-count
        h[s[k]] += e[k];
        --k;
        h[s[k]] -= e[k];
    }
}

void declares_by_the_counter(int k) {
    while (k > 0) { // EXPECT: refuse trip-count
        const int before = k;
        --k;
        h[s[k]] += e[before];
    }
}

void measures_by_the_counter(int k) {
    while (k > 0) { // EXPECT: refuse trip-count
        double w[k];
        --k;
        h[s[k]] += (double)sizeof w;
    }
}

void measures_behind_a_pointer(int k) {
    while (k > 0) { // EXPECT: refuse trip-count
        double(*w)[k];
        --k;
        h[s[k]] += (double)sizeof *w;
    }
}

void steps_again(int k) {
    while (k > 0) { // EXPECT: refuse counter-modified
        --k;
        h[s[k]] += e[k];
        if (s[k] > 3)
            --k;
    }
}

void steps_again_at_the_end(int k) {
    while (k > 0) { // EXPECT: refuse counter-modified
        --k;
        h[s[k]] += e[k];
        --k;
    }
}

void steps_sometimes(int k) {
    while (k > 0) { // EXPECT: refuse trip-count
        if (s[k] > 3)
            --k;
        h[s[k]] += e[k];
    }
}

void steps_in_a_block(int k, int n) {
    while (k > 0) { // EXPECT: refuse trip-count
        if (n)
            continue;
        --k;
        h[s[k]] += e[k];
    }
}

void steps_by_pointer(int k) {
    int *p = &k;
    while (k > 0) { // EXPECT: refuse counter-modified
        --k;
        h[s[k]] += e[k];
        *p -= 1;
    }
}

void steps_away(int k) {
    while (k > 0) { // EXPECT: refuse step
        ++k;
        h[s[k]] += e[k];
    }
}

void over_the_end(int k) {
    while (k) { // EXPECT: refuse step
        k -= 2;
        h[s[k]] += e[k];
    }
}

void over_the_end_unsigned(size_t k) {
    while (k > 0) { // EXPECT: refuse counter-wraps
        k -= 2;
        h[s[k]] += e[k];
    }
}

void without_an_end(size_t k) {
    while (k >= 0) { // EXPECT: refuse counter-wraps
        --k;
        h[s[k]] += e[k];
    }
}

void narrow(unsigned char k) {
    while (k) { // EXPECT: refuse counter-wraps
        --k;
        h[s[k]] += e[k];
    }
}

void compared_as_unsigned(int k, unsigned low) {
    while (k > low) { // EXPECT: refuse counter-wraps
        --k;
        h[s[k]] += e[k];
    }
}

void bound_in_the_body(int k, int low) {
    while (k > low) { // EXPECT: refuse bound-varies
        --k;
        h[s[k]] += e[k];
        low = s[k];
    }
}

void asks_more(int k) {
    while (k > 0 && s[k - 1] > 3) { // EXPECT: refuse trip-count
        --k;
        h[s[k]] += e[k];
    }
}

void asks_otherwise(int k) {
    while (!k) { // EXPECT: refuse trip-count
        --k;
        h[s[k]] += e[k];
    }
}

void header_steps_as_well(int n) {
    for (int k = n; k > 0; k--) { // EXPECT: refuse counter-modified
        --k;
        h[s[k]] += e[k];
    }
}

void header_without_a_step(int n) {
    for (int i = 0; i < n;) { // EXPECT: refuse trip-count
        if (s[i] > 3)
            continue;
        h[s[i]] += e[i];
        i++;
    }
}

extern int shared;

void global(void) {
    while (shared > 0) { // EXPECT: refuse counter-type
        --shared;
        h[s[shared]] += e[shared];
    }
}

void list(const double *p) {
    while (p) { // EXPECT: refuse trip-count
        --p;
        h[(int)*p]++;
    }
}
