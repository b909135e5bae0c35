/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Elements of a table at subscripts that a function computes, without reliable bounds. In other cases a loop or a call
// of floor keeps the subscript unknown.
// covers: row 17 of docs/constructs.md
#include <math.h>

struct table { int n; unsigned m; double x0, x1, inverse, *values; float y0; };

static double not_below(const struct table *t, double r) { /* its lower bound is not the table's start */
    if (r < t->x1)
        r = t->x1;
    int i = (int)floor((r - t->x0) * t->inverse);
    if (i > t->n)
        i = t->n;
    return t->values[i];
}
void other_start(int n, const int *k, const double *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += not_below(t, x[i]);
}

static double below(const struct table *t, double r) { /* no lower bound */
    int i = (int)floor((r - t->x0) * t->inverse);
    if (i > t->n)
        i = t->n;
    return t->values[i];
}
void no_start(int n, const int *k, const double *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += below(t, x[i]);
}

static double beyond(const struct table *t, double r) { /* no upper bound */
    while (r > 1e9)
        r /= 2;
    if (r < t->x0)
        r = t->x0;
    return t->values[(int)((r - t->x0) * t->inverse)];
}
void no_end(int n, const int *k, const double *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += beyond(t, x[i]);
}

static double moved(const struct table *t, int i, int times) { /* moved beyond its bounds */
    if (i < 0)
        i = 0;
    if (i > t->n)
        i = t->n;
    for (int c = 0; c < times; c++)
        i += 3;
    return t->values[i];
}
void moves_on(int n, const int *k, const int *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += moved(t, x[i], k[i]);
}

static void shift(int *i) {
    *i += 3;
}
static double handed(const struct table *t, int i) { /* another function has its address */
    if (i < 0)
        i = 0;
    if (i > t->n)
        i = t->n;
    shift(&i);
    return t->values[i];
}
void address_taken(int n, const int *k, const int *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += handed(t, x[i]);
}

static double one_branch(const struct table *t, int i, int is_kept) {
    while (i > 999)
        i /= 2;
    if (is_kept) {
        if (i < 0)
            i = 0;
        if (i > t->n)
            i = t->n;
    }
    return t->values[i];
}
void sometimes(int n, const int *k, const int *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += one_branch(t, x[i], k[i] % 3);
}

static double wrapped(const struct table *t, int i) { /* a negative value wraps around to a large one */
    while (i > 999)
        i /= 2;
    unsigned at = i - 5;
    if (at > t->m)
        at = t->m;
    return t->values[at];
}
void unsigned_one(int n, const int *k, const int *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += wrapped(t, x[i]);
}

static double against_unsigned(const struct table *t, int i) { /* `m` may exceed INT_MAX */
    while (i > 999)
        i /= 2;
    if (i < 0)
        i = 0;
    if (i > t->m)
        i = 7;
    return t->values[i];
}
void mixed_signs(int n, const int *k, const int *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += against_unsigned(t, x[i]);
}

static double narrow(const struct table *t, int i) { /* 200 becomes -56 */
    while (i > 999)
        i /= 2;
    if (i < 0)
        i = 0;
    if (i > t->n)
        i = t->n;
    signed char at = (signed char)i;
    return t->values[at];
}
void narrower(int n, const int *k, const int *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += narrow(t, x[i]);
}

static double of_float(const struct table *t, double d) { /* after rounding it may be below x0 */
    if (d < t->x0)
        d = t->x0;
    float r = d;
    int i = (int)floor(r - t->x0);
    if (i > t->n)
        i = t->n;
    return t->values[i];
}
void narrower_floats(int n, const int *k, const double *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += of_float(t, x[i]);
}

static double divided(const struct table *t, double r) { /* divided by -0.0 it is negative */
    if (r < t->x0)
        r = t->x0;
    int i = (int)floor((r - t->x0) / t->inverse);
    if (i > t->n)
        i = t->n;
    return t->values[i];
}
void quotient(int n, const int *k, const double *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += divided(t, x[i]);
}

static double few_bits(const struct table *t, double r) { /* a NaN may become any integer */
    signed char i = (signed char)sqrt(r);
    if (i <= 100)
        return t->values[i];
    return 0;
}
void small_integer(int n, const int *k, const double *x, double *h, const struct table *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += few_bits(t, x[i]);
}

static double kept(const struct table *t, int i) {
    if (i < 0)
        i = 0;
    if (i > t->n)
        i = t->n;
    return t->values[i];
}
/* Each iteration has another table. */
void own_table(int n, const int *k, const int *x, double *h, struct table *const *t) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        h[k[i]] += kept(t[i], x[i]);
}
/* Each iteration changes the table's length. */
void moved_end(int n, const int *k, const int *x, double *h, double *values) {
    struct table t = {0};
    t.values = values;
    for (int i = 0; i < n; i++) { // EXPECT: refuse private-not-proved
        t.n = x[i];
        h[k[i]] += kept(&t, x[i]);
    }
}
