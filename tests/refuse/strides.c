/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Variable steps that something may change during the loop, or that may have another sign or type than it seems. */
// covers: row 8, row 10 of docs/constructs.md
#include <stddef.h>

int step_of(int);
void keep(int *p);
extern int shared_stride;
struct view {
    int stride;
};

void changed_in_the_loop(int n, int stride, const int *s, double *h) {
    for (int j = 0; j < n; j += stride) { // EXPECT: refuse step
        h[s[j]] += 1.0;
        stride++;
    }
}

void anew_in_each_iteration(int n, const int *s, double *h) {
    int j = 0;
    while (j < n) { // EXPECT: refuse trip-count
        const int stride = s[j] + 1;
        h[s[j]] += 1.0;
        j += stride;
    }
}

void asked_of_a_function(int n, const int *s, double *h) {
    for (int j = 0; j < n; j += step_of(n)) // EXPECT: refuse step
        h[s[j]] += 1.0;
}

void by_the_counter(int n, const int *s, double *h) {
    for (int j = 1; j < n; j += j) // EXPECT: refuse step
        h[s[j]] += 1.0;
}

void by_multiples(int n, int stride, const int *s, double *h) {
    for (int j = 1; j < n; j *= stride) // EXPECT: refuse step
        h[s[j]] += 1.0;
}

void in_memory(int n, const int *s, double *h) {
    for (int j = 0; j < n; j += shared_stride) // EXPECT: refuse step
        h[s[j]] += 1.0;
}

void in_a_record(int n, const struct view *v, const int *s, double *h) {
    for (int j = 0; j < n; j += v->stride) // EXPECT: refuse step
        h[s[j]] += 1.0;
}

void known_elsewhere(int n, int stride, const int *s, double *h) {
    keep(&stride);
    for (int j = 0; j < n; j += stride) // EXPECT: refuse step
        h[s[j]] += 1.0;
}

void away_from_the_bound(int n, int stride, const int *s, double *h) {
    for (int j = 0; j < n; j -= stride) // EXPECT: refuse step
        h[s[j]] += 1.0;
}

void over_the_bound(int n, int stride, const int *s, double *h) {
    for (int j = 0; j != n; j += stride) // EXPECT: refuse step
        h[s[j]] += 1.0;
}

void divided(int n, int stride, const int *s, double *h) {
    for (int j = 0; j < n; j += n / stride) // EXPECT: refuse step
        h[s[j]] += 1.0;
}

void fractions(int n, double stride, const int *s, double *h) {
    for (int j = 0; j < n; j += stride) // EXPECT: refuse step
        h[s[j]] += 1.0;
}

void unsigned_and_down(unsigned n, unsigned stride, const int *s, double *h) {
    for (unsigned j = n; j > 2; j -= stride) // EXPECT: refuse counter-wraps
        h[s[j]] += 1.0;
}

void unsigned_up_to_the_last(unsigned n, unsigned stride, const int *s, double *h) {
    for (unsigned j = 0; j <= n; j += stride) // EXPECT: refuse counter-wraps
        h[s[j]] += 1.0;
}

void up_to_a_wider_bound(size_t n, unsigned stride, const int *s, double *h) {
    for (unsigned j = 0; j < n; j += stride) // EXPECT: refuse counter-wraps
        h[s[j]] += 1.0;
}

void narrow(int n, short stride, const int *s, double *h) {
    for (short j = 0; j < n; j += stride) // EXPECT: refuse counter-wraps
        h[s[j]] += 1.0;
}
