/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Iterations that leave the loop, where the condition cannot be evaluated in advance: it depends on updated data, has
// side effects or depends on a sum. Also: messages under such conditions, in every iteration, or in both branches.
#include <stdio.h>
#include <stdlib.h>

void by_update(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        if (h[k[t]] > 1e9)
            return;
        h[k[t]] += v[t];
    }
}

int next(int);

void by_effect(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse break
        if (next(t))
            break;
        h[k[t]] += v[t];
    }
}

void tick(int *);

void by_header(int n, const int *k, double *h, const double *v) {
    int ticks = 0;
    for (int t = 0; t < n; t++, tick(&ticks)) // EXPECT: refuse impure-call
        h[k[t]] += v[t];
    for (int t = n; t-- > 0; tick(&ticks)) // EXPECT: refuse impure-call
        h[k[t]] += v[t];
    for (const int *p = k; p < k + n; p++, tick(&ticks)) // EXPECT: refuse impure-call
        h[*p] += 1;
}

int state;

void by_global(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse break
        if ((state = k[t]) < 0)
            break;
        h[k[t]] += v[t];
    }
}

void by_carried(int n, const int *k, double *h, const double *v) {
    int errors = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        if (v[t] < 0 && ++errors > 10)
            break;
        h[k[t]] += v[t];
    }
}

void by_assigned_update(int n, const int *k, double *h, const double *v) {
    double before;
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        if ((before = h[k[t]]) > 1e9)
            return;
        h[k[t]] += v[t];
    }
}

void goes_on(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        if (h[k[t]] < 0)
            fprintf(stderr, "iteration %d\n", t);
        h[k[t]] += v[t];
    }
}

void always(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        fprintf(stderr, "iteration %d\n", t);
        h[k[t]] += v[t];
    }
}

void one_or_the_other(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        if (v[t] < 0)
            fprintf(stderr, "iteration %d\n", t);
        else
            fprintf(stderr, "iteration %d: %g\n", t, v[t]);
        h[k[t]] += v[t];
    }
}

int counts(int n, const int *k, double *h, const double *v) {
    int errors = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        if (v[t] < 0)
            errors++;
        if (errors > 10)
            return errors;
        h[k[t]] += v[t];
    }
    return 0;
}

void in_a_switch(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse return
        switch (k[t]) {
        case 1:
            return;
        default:
            h[k[t]] += v[t];
        }
}

/* The pointer exists only if the first iteration does not leave. A restrict pointer is not loaded in advance. */
struct system { double *restrict h; };
void before_a_pointer(int n, const int *k, const struct system *s, const double *v, int skip) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse base-conditional
        if (skip)
            break;
        s->h[k[t]] += v[t];
    }
}
