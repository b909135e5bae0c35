/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Updates, private variables and subscripts that almost have an accepted form.
// covers: row 24, row 33, row 31, row 59 of docs/constructs.md
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
double g;
extern double eg;
int gi;
static int gs[100];
double table[100];
typedef struct {
    double f[3];
    int n;
} S;
double last_cond(int n, const int *k, double *h, const double *w) {
    double d = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse last-value
        if (w[t] > 0) {
            const double e = d = w[t];
            h[k[t]] += e;
        }
    }
    return d;
}

int last_inner(int n, const int *k, double *h) {
    int c = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse last-value
        if (k[t] > 3)
            for (c = 0; c < k[t]; c++)
                h[k[t]] += c;
    }
    return c;
}

void sub_private_escape(int n, const int *k, double *h, int **out) {
    int i = 0;
    *out = &i;
    for (int t = 0; t < n; t++) { // EXPECT: refuse escapes
        i = k[t];
        h[i] += 1;
    }
}

void nested_update_in_private(int n, const int *k, double *h) {
    double a[4] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        a[k[t]] += 1;
        h[k[t]] += a[0];
    }
}

void static_local(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        static int calls;
        calls++;
        h[k[t]] += calls;
    }
}

static double mem(double v) {
    static double old;
    double r = old;
    old = v;
    return r;
}

void callee_static(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[k[t]] += mem(t);
}

static int *ptr_to(int *a, int i) {
    if (i < 0)
        return a;
    return a + i;
}

void via_returned(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse base-varies
        *ptr_to(h, k[t]) += 1;
}

void store_via_returned(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse other-store
        h[k[t]] += 1;
        *ptr_to(h, t) = 0;
    }
}

void struct_copy(int n, const int *k, S *s) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        S c = s[t];
        s[k[t]].f[0] += c.f[1];
    }
}

void struct_assign(int n, const int *k, S *s) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        s[k[t]].f[0] += 1;
        s[t] = s[t + 1];
    }
}

void swapped(int n, int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-array-written
        int x = k[t];
        k[t] = k[n - 1 - t];
        k[n - 1 - t] = x;
        h[k[t]] += 1;
    }
}

void count_then_use(int n, const int *k, int *c, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        c[k[t]]++;
        h[c[t]] += 1;
    }
}

void ptr_walk2(int n, const int *k, double *h) {
    const int *p = k;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        h[*p] += 1;
        if (*p == 3)
            p++;
    }
}

void cond_pub(int n, const int *k, double *h, int *flag) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-array-written
        if (k[t] == 7)
            *flag = 1;
        if (!*flag)
            h[k[t]] += 1;
    }
}

void gwrite(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse other-store
        g = k[t];
        h[k[t]] += g;
    }
}

static void upd(double *p, int i, double v) {
    if (p[0] > 0)
        p[i] += v;
}

void by_callee(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse callee-updates
        upd(h, k[t], 1.0);
        h[k[t]] += 2;
    }
}

static void gupd(int i) {
    table[i] *= 2;
}

void by_callee_global(int n, const int *k) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        table[k[t]] += 1;
        gupd(t);
    }
}

void andand(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse update-in-expression
        k[t] && h[k[t]]++;
}

void linked(int n, const int *k, double *h, int *next) {
    for (int t = 0; t < n; t++) {
        int i = k[t];
        while (i > 0) { // EXPECT: refuse trip-count
            h[i] += 1;
            next[i]++;
            i = next[i];
        }
    }
}

/* Such a subscript must be computed only once, which only binning does, and these loops have no binned form. */
void logarithm_of_a_forwarded_value(int n, double *restrict h, int *restrict o, const double *x) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-too-dear
        o[t] = (int)(log(x[t]) * 10);
        h[o[t]] += 1;
    }
}

void power_of_the_last(int n, double *h, const float *x, float *last) {
    float scaled = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-too-dear
        scaled = powf(x[t], 0.5f);
        h[(int)scaled] += 1;
    }
    *last = scaled;
}

void extended(int n, long double *h, const double *x) {
    for (int t = 0; t < n; t++) // EXPECT: refuse index-too-dear
        h[(int)(x[t] * 10.0L)] += 1;
}

void leaving(int n, double *restrict h, const double *x) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-too-dear
        if (x[t] < 0)
            break;
        h[(int)(log(x[t]) * 10)] += 1;
    }
}

/* The condition of a load may depend on an updated element. */
void unverified(int n, double *h, const double *x, const int *map) {
    for (int t = 0; t < n; t++) // EXPECT: refuse index-too-dear
        h[map[(int)log(x[t])]] += 1;
}

/* The condition decides the value of `k`, or whether an inner loop runs that may not end otherwise. */
void behind_the_branch(int n, int *h, const unsigned char *set, const int *map) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-too-dear
        int k = 3;
        if (set[t] == 255)
            k = t / 2;
        h[map[k] + (int)log(t + 1.0)]++;
    }
}

void up_to_any_number(unsigned n, int *h, const unsigned char *set, unsigned last) {
    for (unsigned t = 0; t < n; t++) // EXPECT: refuse index-too-dear
        if (set[t] == 255)
            for (unsigned k = 0; k <= last; k++)
                h[(int)log(k + t + 1.0)]++;
}

void by_any_step(int n, int *h, const unsigned char *set) {
    for (int t = 0; t < n; t++) // EXPECT: refuse index-too-dear
        if (set[t] == 255)
            for (int k = 0; k < n; k += t % 3)
                h[(int)log(k + t + 1.0)]++;
}

double measured(double v) __attribute__((const));
void by_unknown_function(int n, double *h, const double *x) {
    for (int t = 0; t < n; t++) // EXPECT: refuse unseen-pure
        h[(int)measured(x[t])] += 1;
}

void running_sum(int n, double *h, const double *x) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        sum += x[t];
        h[(int)(sum * 10)] += 1;
    }
}

void of_the_array(int n, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        h[(int)(h[t] * 10)] += 1;
}
