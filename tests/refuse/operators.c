/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// An element's new value depends on more than its old value and the iteration's operands.
// covers: row 22, row 23, row 27, row 28, row 32, row 37 of docs/constructs.md
#include <math.h>

void of_another(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] = h[k[t + 1]] + 1.0;
}

void place_of_most(int n, const int *k, double *h, int *at, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (v[t] > h[k[t]]) {
            h[k[t]] = v[t];
            at[k[t]] = t;
        }
}

void least_and_count(int n, const int *k, double *h, const double *v, int *changes) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (v[t] < h[k[t]]) {
            h[k[t]] = v[t];
            changes[k[t]]++;
        }
}

void of_the_neighbour(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (v[t] < h[k[t]])
            h[k[t] + 1] = v[t];
}

int lazily_filled(int n, const int *k, int *pos) {
    int next = 0;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (pos[k[t]] == -1)
            pos[k[t]] = next++;
    return next;
}

void most_is_read(int n, const int *k, double *h, const double *v, double *out) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        h[k[t]] = h[k[t]] > v[t] ? h[k[t]] : v[t];
        out[t] = h[k[t]];
    }
}

void most_guarded(int n, const int *k, double *h, const double *v, int m) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (k[t] < m && h[k[t]] < v[t])
            h[k[t]] = v[t];
}

void subscript_changes(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        int i = k[t];
        if (h[i] < v[t])
            h[i++] = v[t];
        h[i] *= 2.0;
    }
}

void compared_by_callee(int n, const int *k, double *h, const double *v);
static int exceeds(const double *at, double v) {
    return *at < v;
}
void compared_by_callee(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (exceeds(&h[k[t]], v[t]))
            h[k[t]] = v[t];
}

void stored_then_read(int n, const int *k, double *h, double *o) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        o[t] = 0.5 * t;
        h[k[t]] += o[t] + o[0];
    }
}

void kept_value(int n, const int *k, double *h, double *out) {
    double last = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse update-value-used
        last = h[k[t]] /= 2.0;
        *out = last;
    }
}

struct flags {
    unsigned low : 4, high : 4;
};

void bits(int n, const int *k, struct flags *f) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        f[k[t]].low <<= 1;
}

union word {
    float f;
    unsigned u;
};

void union_kept(int n, const int *k, union word *w) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        if (w[k[t]].f > 0)
            w[k[t]].u |= 0x80000000u;
}
