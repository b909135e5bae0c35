/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The smallest changes by which calls as in accept/calls_of_pairs.c cannot be replaced by the functions' bodies, or by
// which the loop stays sequential with the bodies in their places.
// covers: row 14, row 18, row 19
#include <stdio.h>
typedef struct {
    double x, f;
    int seen;
} body;
static double radius = 2.0;
static body *last;

static void reads_updated(body *a, body *b) {
    const double d = a->x - b->x;
    a->f += d;
    b->f -= d * a->f;
}
void updated_field(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            reads_updated(&p[i], &p[j]);
}

static void counts(body *a, body *b) {
    static int calls;
    a->f += ++calls;
    b->f -= 1.0;
}
void static_variable(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: refuse impure-call
        for (int j = i + 1; j < n; j++)
            counts(&p[i], &p[j]);
}

static void strong(body *a, body *b) {
    static double strength = 2.0;
    const double d = strength * (a->x - b->x);
    a->f += d;
    b->f -= d;
}
void static_read(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            strong(&p[i], &p[j]);
}

static void keeps(body *a, body *b) {
    last = a;
    a->f += 1.0;
    b->f -= 1.0;
}
void address_kept(int n, const int (*k)[2], body *p) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        keeps(&p[k[t][0]], &p[k[t][1]]);
}

static void by_pointer(body *a, body *b, double (*law)(double)) {
    const double d = law(a->x - b->x);
    a->f += d;
    b->f -= d;
}
void function_pointer(int n, body *p, double (*law)(double)) {
    for (int i = 0; i < n; i++) // EXPECT: refuse function-pointer
        for (int j = i + 1; j < n; j++)
            by_pointer(&p[i], &p[j], law);
}

static void again(body *a, body *b, int depth) {
    a->f += 1.0;
    b->f -= 1.0;
    if (depth > 0)
        again(b, a, depth - 1);
}
void recursion(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int j = i + 1; j < n; j++)
            again(&p[i], &p[j], 2);
}

static void pull(body *a, body *b, double d) {
    a->f += d;
    b->f -= d;
}
/* the arguments' order is open */
void stepped_arguments(int n, const int *k, body *p) {
    int c = 0;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        pull(&p[k[c++]], &p[k[c++]], 1.0);
}
static int stepped(int *c) {
    return ++*c;
}
void changing_arguments(int n, const int *k, body *p) {
    int c = 0;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        pull(&p[k[stepped(&c)]], &p[k[stepped(&c)]], 1.0);
}

/* another program compiles another function */
static void branches(body *a, body *b) {
#ifdef BOTH
    a->f += 2.0;
#else
    a->f += 1.0;
#endif
    b->f -= 1.0;
}
void directive(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            branches(&p[i], &p[j]);
}

static void leaves(body *a, body *b) {
    for (int c = 0; c < 3; c++)
        if (a->x > c)
            return;
    a->f += 1.0;
    b->f -= 1.0;
}
void return_in_loop(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            leaves(&p[i], &p[j]);
}

static void jumps(body *a, body *b) {
    if (a->x > b->x)
        goto done;
    a->f += 1.0;
    b->f -= 1.0;
done:;
}
void label(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            jumps(&p[i], &p[j]);
}

/* Some returns of a branch, and not all. */
static void perhaps(body *a, body *b) {
    if (a->x > 0.0) {
        if (b->x > 0.0)
            return;
        a->f += 1.0;
    }
    b->f -= 1.0;
}
void undecided(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            perhaps(&p[i], &p[j]);
}

__attribute__((weak)) void replaced(body *a, body *b) {
    a->f += 1.0;
    b->f -= 1.0;
}
void other_definition(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int j = i + 1; j < n; j++)
            replaced(&p[i], &p[j]);
}

__attribute__((no_instrument_function)) static void otherwise(body *a, body *b) {
    const double d = a->x - b->x;
    a->f += d;
    b->f -= d;
}
void compiled_otherwise(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            otherwise(&p[i], &p[j]);
}

static void within(body *a, body *b) {
    if (a->x - b->x > radius)
        return;
    a->f += 1.0;
    b->f -= 1.0;
}
/* In the loop, the name means another variable. */
void hidden_name(int n, body *p, double radius) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            if (p[i].x < radius)
                within(&p[i], &p[j]);
}

static double both(body *a, body *b, double *sum) {
    a->f += 1.0;
    b->f -= 1.0;
    *sum += a->x;
    return b->x;
}
double sum_of_both(int n, body *p) {
    double sum = 0.0;
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            sum += both(&p[i], &p[j], &sum);
    return sum;
}

/* A loop over time steps is no candidate. */
typedef struct {
    int at[8], step;
    body *of;
} world;
static void advance(world *w) {
    w->of[w->at[w->step]].f += 1.0;
    printf("%d\n", w->step);
    w->step = (w->step + 1) & 7;
}
void time_steps(int n, world *w) {
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        advance(w);
}
