/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/idioms.c and must not be transformed.
// covers: row 62, row 73, row 74, row 75, row 76, row 77, row 83, row 84 of docs/constructs.md
#include <assert.h>

enum { N = 3000 };
struct graph {
    int count;
    const int *to;
};
extern int s[N], asked;
extern double e[N];

/* ---- *p instead of p[0] ---- */

void table_changes(int n, double **out, double *other) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse other-store
        (*out)[s[t]] += e[t];
        *out = other;
    }
}

void pointer_moves(int n, double **out) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse base-varies
        (*out)[s[t]] += e[t];
        out++;
    }
}

void read_by_the_other_name(int n, double **out) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        (*out)[s[t]] += out[0][t];
}

/* ---- bounds ---- */

int bound_wanted_after(const struct graph *x, double *h) {
    int v, end;
    for (v = 0, end = x->count; v < end; v++) // EXPECT: refuse last-value
        h[x->to[v]] += e[v];
    return end;
}

void bound_read_in_body(const struct graph *x, double *h) {
    int v, end;
    for (v = 0, end = x->count; v < end; v++) // EXPECT: refuse trip-count
        h[x->to[v]] += end;
}

void bound_of_the_counter(const struct graph *x, double *h) {
    int v, end;
    for (v = 0, end = v + x->count; v < end; v++) // EXPECT: refuse trip-count
        h[x->to[v]] += 1;
}

static int asks(const struct graph *x) {
    return ++asked < x->count ? x->count : 0;
}

void bound_with_effect(const struct graph *x, double *h) {
    for (int v = 0; v < asks(x); v++) // EXPECT: refuse impure-call
        h[x->to[v]] += 1;
}

static int shrink(int *left) {
    return --*left;
}

void bound_that_writes(const struct graph *x, double *h) {
    int left = x->count;
    for (int v = 0; v < shrink(&left); v++) // EXPECT: refuse trip-count
        h[x->to[v]] += 1;
}

static int up_to(const int *p) {
    return *p;
}

void bound_that_is_counted(const int *to, int *h) {
    for (int v = 0; v < up_to(h); v++) // EXPECT: refuse callee-reads
        h[to[v]] += 1;
}

int anything(const struct graph *x);

void bound_unknown(const struct graph *x, double *h) {
    for (int v = 0; v < anything(x); v++) // EXPECT: refuse impure-call
        h[x->to[v]] += 1;
}

static int rounded(const struct graph *x) {
    return (int)(0.1 * x->count);
}

void bound_that_is_rounded(const struct graph *x, double *h) {
    for (int v = 0; v < rounded(x); v++) // EXPECT: refuse trip-count
        h[x->to[v]] += 1;
}

/* ---- a counter whose address another function has stored ---- */

void report(const char *who, int *place);
extern int *kept;

void counter_may_be_read(int n, double *h) {
    int i;
    report("who", &i);
    for (i = 0; i < n; i++) // EXPECT: refuse counter-modified
        h[s[i]] += *kept;
}

void counter_may_be_updated(int n, int *h) {
    int i;
    report("who", &i);
    for (i = 0; i < n; i++) // EXPECT: refuse counter-modified
        h[s[i]]++;
}

void counter_changed_by_pointer(int n, double *h) {
    int i, *here = &i;
    for (i = 0; i < n; i++) { // EXPECT: refuse counter-modified
        h[s[i]] += 1;
        *here += s[i] & 1;
    }
}

void counter_read_by_pointer(int n, double *h) {
    int i, *here = &i;
    for (i = 0; i < n; i++) // EXPECT: refuse counter-modified
        h[s[i]] += *here;
}

void counter_given_away_inside(int n, double *h) {
    int i;
    for (i = 0; i < n; i++) { // EXPECT: refuse counter-modified
        int *here = &i;
        h[s[i]] += *here;
    }
}

/* ---- array and subscript are separate arguments ---- */

static void add_both(double *to, int k, double value) {
    to[k] += value;
    to[k + 1] -= value * to[k];
}

void two_elements(int n, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        add_both(h, s[t], e[t]);
}

static void add_where(double *to, int k, double value) {
    if (to[k] >= 0)
        to[k + 1] += value;
}

void perhaps(int n, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        add_where(h, s[t], e[t]);
}

static void add_looked_up(double *to, const int *k, int t, double value) {
    to[k[t]] += value * to[t];
}

void looked_up_inside(int n, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        add_looked_up(h, s, t, e[t]);
}

static void add_neighbour(double *to, int k) {
    to[k] += 0.5 * to[k + 1];
}

void reads_another(int n, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        add_neighbour(h, s[t]);
}

static void add_at(double *to, int k, double value) {
    to[k] += value;
}

void subscript_with_effect(int n, double *h) {
    int k = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse scalar-carried
        add_at(h, s[k++], e[t]);
}

/* ---- a failed assertion ends the program ---- */

void asserted(int n, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse no-return
        assert(++e[t] >= 0);
        h[s[t]] += 1.0;
    }
}

/* ---- statement expressions that store an address, besides the assertion ---- */

void address_kept(int n, double *restrict h) {
    int k;
    int *const p = ({ assert(n > 0); &k; });
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        k = s[t];
        h[s[t] - *p] += e[t];
    }
}

void carried_by(int n, double *restrict h) {
    int k = ({ n / 2; });
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        h[k] += e[t];
        k = s[t];
    }
}

void address_in_assembly(int n, double *restrict h) {
    int k;
    __asm__ volatile("" : : "r"(&k) : "memory");
    for (int t = 0; t < n; t++) { // EXPECT: refuse escapes
        k = s[t];
        h[k] += e[t];
    }
}

/* ---- an update of one fixed element in addition to the others ---- */

void one_alone(int n, int *h, const int *other) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        h[0] += other[s[t]];
        h[1]++;
    }
}

int one_is_read(int n, int *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse update-value-used
        h[s[t]]++;
        if (h[0]++ > 5)
            h[s[t]]++;
    }
    return h[0];
}

/* ---- static variables in the body that are not constant ---- */

void not_constant(int n, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        static double weight[2] = {1, 2};
        h[s[t]] += weight[t & 1];
    }
}

void by_address(int n, const int **restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        static const int here = 1;
        h[s[t]] = &here;
    }
}

void address_as_value(int n, const double *const *restrict marks, int *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        static const double mark[2] = {1, 2};
        if (marks[t] == mark)
            h[s[t]]++;
    }
}
