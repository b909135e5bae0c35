/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Branches that may be executed: the function's result varies, another definition may replace the function, the
// variable changes in between, a jump skips its assignment, or its type cannot hold the constant.
// covers: row 98 of docs/constructs.md

#include <stdio.h>
#include <stdlib.h>

static int differs(int t) {
    if (t == 1000)
        return 0;
    return 1;
}

__attribute__((weak)) int replaceable(int t) {
    return t ? 1 : 1;
}

static int one(int t) {
    return t ? 1 : 1;
}

static unsigned char wraps(int t) {
    return t ? -1 : -1;
}

static int unlike(int t) {
    return t ? 1 : 2;
}

void by_results(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        int ok = differs(t);
        if (ok)
            h[0] += 1.0;
        else
            printf("%d\n", t);
        h[k[t]] += v[t];
    }
}

void next(int);

void by_values(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        if (unlike(t) == 2)
            next(t);
        else
            h[k[t]] += v[t];
    }
}

void by_another_definition(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        if (replaceable(t))
            h[0] += 1.0;
        else
            printf("%d\n", t);
        h[k[t]] += v[t];
    }
}

void by_conversion(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        if (wraps(t) == -1)
            h[k[t]] += 1.0;
        else
            next(255);
        h[k[t]] += v[t];
    }
}

void changed_between(int n, const int *k, double *h, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        int ok = one(t);
        if (v[t] < 0)
            ok = 0;
        if (ok)
            h[0] += 1.0;
        else
            puts("negative");
        h[k[t]] += v[t];
    }
}

void through_a_pointer(int n, const int *k, double *h, const double *v) {
    int ok, *status = &ok;
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        ok = one(t);
        *status = v[t] > 0;
        if (ok)
            h[0] += 1.0;
        else
            puts("negative");
        h[k[t]] += v[t];
    }
}

void past_the_assignment(int n, const int *k, double *h, const double *v) {
    int ok = 0;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        if (v[t] < 0)
            goto behind;
        ok = one(t);
    behind:
        if (ok)
            h[0] += 1.0;
        else
            puts("negative");
        h[k[t]] += v[t];
        ok = 0;
    }
}

void of_the_iteration_before(int n, const int *k, double *h, const double *v) {
    int ok = one(0);
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        if (ok)
            h[0] += 1.0;
        else
            puts("negative");
        ok = v[t] > 0;
        h[k[t]] += v[t];
    }
}

void in_a_later_case(int n, const int *k, double *h, const double *v) {
    int ok = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        switch (k[t] & 1) {
            ok = one(t);
        case 0:
            if (ok)
                h[0] += 1.0;
            else
                puts("even");
        }
        h[k[t]] += v[t];
    }
}
