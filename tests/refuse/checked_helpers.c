/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The smallest changes by which functions as in accept/checked_helpers.c cannot be replaced by their bodies, or by which
// their checks cannot be made before the iterations.
// covers: row 14, row 18, row 20
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
typedef struct vector {
    int n, used;
    double *p;
} vector;

/* The update changes what the next check reads. */
static void add_while_room(vector *a, int i, double x) {
    if (a->used >= a->n) {
        fprintf(stderr, "%d\n", i);
        exit(1);
    }
    a->p[i] += x;
    a->used++;
}
void counted_in_memory(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        add_while_room(a, k[t], w[t]);
}

static int add_below(vector *a, int i, double x) {
    if (a->p[i] > 1e9) {
        fprintf(stderr, "%d\n", i);
        return 1;
    }
    a->p[i] += x;
    return 0;
}
int updated_element(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse return
        if (add_below(a, k[t], w[t]))
            return t;
    return n;
}

static int add_then_check(vector *a, int i, double x) {
    a->p[i] += x;
    return a->p[i] > 1e9;
}
int after_the_update(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse return
        if (add_then_check(a, k[t], w[t]))
            return t;
    return n;
}

static void add_first(vector *a, int i, double x) {
    static int calls;
    if (calls++ > 1000) {
        fprintf(stderr, "%d\n", i);
        exit(1);
    }
    a->p[i] += x;
}
void static_variable(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        add_first(a, k[t], w[t]);
}

static int failures;
static int add_and_count(vector *a, int i, double x) {
    if (i >= a->n)
        return ++failures;
    a->p[i] += x;
    return failures > 3;
}
int global_variable(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse return
        if (add_and_count(a, k[t], w[t]))
            return t;
    return n;
}

static void add_again(vector *a, int i, double x) {
    if (i > 100)
        add_again(a, i - 100, x);
    a->p[i] += x;
}
void recursion(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse recursion
        add_again(a, k[t], w[t]);
}

static void add_and_tell(vector *a, int i, double x) {
    fprintf(stderr, "%d\n", i);
    a->p[i] += x;
}
void always(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        add_and_tell(a, k[t], w[t]);
}

static int add_or_fail(vector *a, int i, double x) {
    if (i >= a->n) {
        fprintf(stderr, "%d\n", i);
        return -1;
    }
    a->p[i] += x;
    return 0;
}
/* The call is executed under a condition, twice, or decides whether another loop goes on. */
int under_a_condition(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse return
        if (w[t] > 0 && add_or_fail(a, k[t], w[t]))
            return t;
    return n;
}
int twice(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse return
        if (add_or_fail(a, k[t], w[t]) + add_or_fail(a, k[t] / 2, 1.0))
            return t;
    return n;
}
int in_an_inner_header(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        int i = k[t];
        while (add_or_fail(a, i, w[t]))
            i--;
    }
    return n;
}

/* The sequential program may add in front of the messages, so they cannot be told apart from the updates. */
static int failed(vector *a, int i) {
    fprintf(stderr, "%d\n", i);
    a->p[0] = 0;
    return i % 2;
}
int message_in_the_condition(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse return
        if (failed(a, k[t]))
            return t;
        a->p[k[t]] += w[t];
    }
    return n;
}

static void add_asserted(vector *a, int i, double x) {
    a->p[i] += x;
    assert(a->p[i] < 1e9);
}
void assertion_of_an_update(vector *a, int n, const int *k, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: refuse index-too-dear
        add_asserted(a, k[t], w[t]);
}
