/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/load_modify_store.c and must not be transformed.
// covers: row 82 of docs/constructs.md

enum { N = 4000 };
extern int k[N], second[N];
extern double w[N], out[N], h[N];

void value_used_after(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double v = h[k[t]];
        v += w[t];
        h[k[t]] = v;
        out[t] = v;
    }
}

void value_used_after_by_an_outer_one(int n) {
    double v;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        v = h[k[t]];
        v += w[t];
        h[k[t]] = v;
        out[t] = v;
    }
}

void exchanged(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double v = h[k[t]];
        h[k[t]] = h[second[t]];
        h[second[t]] = v;
    }
}

void another_element(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        double v = h[k[t]];
        v += h[second[t]];
        h[k[t]] = v;
    }
}

void subscript_moves(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        int i = k[t];
        double v = h[i];
        i = second[t];
        h[i] = v + w[t];
    }
}

void another_effect(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double v = h[k[t]];
        out[t] = w[t];
        v += w[t];
        h[k[t]] = v;
    }
}

void carried(int n) {
    double v = 0;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double before = v;
        v = h[k[t]];
        v += before;
        h[k[t]] = v;
    }
}

void left_in_between(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double v = h[k[t]];
        if (v > 1)
            continue;
        h[k[t]] = v + 1;
    }
}

void stored_twice(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double v = h[k[t]];
        h[k[t]] = v + 1;
        h[k[t]] = v + 2;
    }
}

static int steps;
static double step(double v) {
    steps++;
    return v + steps;
}

void counted_in_between(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        double v = h[k[t]];
        v = step(v);
        h[k[t]] = v;
    }
}

void in_parts(int n, const double *x) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double v = h[k[t]];
        if (x[t] > 0) {
            v += 1;
            h[k[t]] = v;
        }
    }
}
