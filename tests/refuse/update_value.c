/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The loop uses the value of an update, or the update is part of a larger expression.
// covers: row 24, row 36, row 35 of docs/constructs.md
#include <stdlib.h>

extern int sink;

/* The last loop of a counting sort: the iterations' order determines the positions. */
void scatter(int n, const int *key, int *place, int *sorted) {
    for (int t = 0; t < n; t++) // EXPECT: refuse update-value-used
        sorted[place[key[t]]++] = key[t];
}

void old_value(int n, const int *k, int *h, int *seen) {
    for (int t = 0; t < n; t++) // EXPECT: refuse update-value-used
        seen[t] = h[k[t]]++;
}

void new_value(int n, const int *k, double *h, double *seen) {
    for (int t = 0; t < n; t++) // EXPECT: refuse update-value-used
        seen[t] = h[k[t]] += 1.0;
}

void in_condition(int n, const int *k, int *h) {
    int full = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse update-value-used
        if (++h[k[t]] > 7)
            full = 1;
    sink = full;
}

void chained(int n, const int *k, int *h, int *g) {
    for (int t = 0; t < n; t++) // EXPECT: refuse update-value-used
        g[k[t]] += h[k[t]] += 1;
}

void as_subscript(int n, const int *k, int *h, int *g) {
    for (int t = 0; t < n; t++) // EXPECT: refuse update-value-used
        g[h[k[t]]++] += 1;
}

void as_argument(int n, const int *k, int *h, int *g) {
    for (int t = 0; t < n; t++) // EXPECT: refuse update-value-used
        g[k[t]] += abs(h[k[t]]++);
}

void returned(int n, const int *k, double *h, double *best) {
    double last = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse update-value-used
        last = h[k[t]] -= 2.0;
    }
    *best = last;
}
