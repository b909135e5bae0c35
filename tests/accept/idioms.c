/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops as programs write them: *p for p[0], bounds that the header sets or a function returns, a counter
// whose address was passed on, and arrays and subscripts passed as separate arguments.
// covers: row 73, row 74, row 75, row 76, row 77, row 83, row 84, row 62 of docs/constructs.md
#include <assert.h>

#include "case.h"

enum { N = 3000, ROWS = 70 };
static int s[N], second[N];
static double e[N], h[ROWS], g[ROWS], wide[ROWS][3];
static long counted[ROWS];
static double *where = h;
static long last_seen;

/* ---- *p instead of p[0] ---- */

static void by_pointer_before(int n, double **out) {
    double *u = *out;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        u[s[t]] += e[t];
}

static void by_pointer_each_time(int n, double **out) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        (*out)[s[t]] += e[t];
        out[0][second[t]] -= 0.5 * e[t];
        *(*out + s[t]) += 1.0;
    }
}

static void by_pointer_inside(int n, double **out) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *u = *out, *row = &(*out)[second[t]];
        u[s[t]] = 0.25 * u[s[t]] + e[t];
        *row += 1.0;
    }
}

static void read_by_pointer(int n, double *restrict to, int *const *subscripts, double *const *from) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[(*subscripts)[t]] += (*from)[t];
}

static void of_global(int n) {
    double **at = &where;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        (*at)[s[t]] += e[t];
}

/* ---- bounds ---- */

struct graph {
    int count, first;
    const int *to;
};

static int size_of(const struct graph *x) {
    return x->count > 0 ? x->count : 0;
}

static int end_of(const struct graph *x, int from) {
    const int end = from + size_of(x) / 2;
    return end < x->count ? end : x->count;
}

static int bound_in_header(const struct graph *x, int base) {
    int v, end, sum = 0;
    for (v = base, end = x->count; v < end; v++) // EXPECT: transformed
        h[x->to[v]] += e[v];
    sum += v;
    for (end = base / 2 + x->count / 2, v = base; v < end; v++) // EXPECT: transformed
        g[x->to[v]] -= e[v];
    return 10 * sum + v;
}

static long bound_of_a_function(const struct graph *x) {
    long v;
    for (v = x->first; v < size_of(x); v++) // EXPECT: transformed
        h[x->to[v]] += e[v];
    for (int w = 2; w <= end_of(x, x->first) - 1; w += 3) // EXPECT: transformed
        counted[x->to[w]] += w;
    return v;
}

/* ---- a counter whose address another function has stored ---- */

static const int *kept;

__attribute__((noinline)) static void report(const char *who, int *place) {
    *place = (int)who[0];
    kept = place;
}

static void counter_given_away(int n) {
    int i;
    report("who", &i);
    for (i = 0; i < n; i++) // EXPECT: transformed
        h[s[i] % ROWS] += e[i];
    last_seen = last_seen * 3 + *kept;
    for (i = n; i > 3; i -= 2) // EXPECT: transformed
        g[s[i - 1]] -= e[i - 1];
    last_seen = last_seen * 3 + *kept;
}

/* ---- array and subscript are separate arguments ---- */

static void add_at(double *to, int k, double value) {
    to[k] += value;
}

static void blend_at(double *to, long k, double value) {
    to[k - 1] = 0.5 * to[k - 1] + value;
    to[k - 1] -= 0.125;
}

static void add_entry(double (*to)[3], int row, int column, double value) {
    to[row][column % 3] += value;
}

static void count_at(long *to, unsigned char k) {
    to[k]++;
}

static void apart(int n, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        add_at(to, s[t], e[t]);
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        blend_at(g, s[t] + 1, e[t]);
        add_at(g, second[t], e[t]);
        add_at(g + 1, s[t] / 2, 1.0);
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        add_entry(wide, s[t], t & 3, e[t]);
        if (t % 5 != 0)
            wide[second[t]][1] += 1.0;
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        count_at(counted, s[t] + 256 * t);
}

/* ---- an update of one fixed element in addition to the others ---- */

static void beside(int n, long *to, int m) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        to[0]++;
        if (e[t] > 0.25)
            to[m] += 3;
        to[s[t]] += t;
    }
}

/* ---- static constants in the body ---- */

static void by_constants(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        static const double weight[2][3] = {{0.5, 0.25, 0.25}, {1, 2, 3}};
        static const int twice = 2;
        for (int c = 0; c < 3; c++)
            wide[s[t]][c] += weight[t & 1][c] * twice;
    }
}

/* ---- assert before and after loops: under gcc it is a statement expression ---- */

static int beside_assertions(int n, const int *first, const int *to, double *restrict out) {
    int i, j, last = -1;
    assert(n > 0);
    for (i = 0; i < n; i++) // EXPECT: transformed
        for (j = first[i]; j < first[i + 1]; j++)
            out[to[j]] += e[j];
    assert(i == n);
    for (i = 0; i < n; i++) { // EXPECT: transformed
        last = to[i];
        out[last] -= 1;
    }
    assert(({ last >= 0; }));
    return last;
}

int main(void) {
    int *const subscripts[1] = {second};
    double *const values[1] = {e};
    double *out = g;
    int first[N / 10 + 1];
    long sum = 0;
    case_values(e, N);
    for (int i = 0; i <= N / 10; i++)
        first[i] = 10 * i - i % 4;
    for (int round = 0; round < 4; round++) {
        const struct graph x = {N - 7 * round, 5, round % 2 ? s : second};
        case_subscripts(s, N, ROWS);
        if (round % 2 == 0)
            case_near_subscripts(second, N, ROWS);
        by_pointer_before(N, &out);
        by_pointer_each_time(N, &out);
        by_pointer_inside(N, &out);
        read_by_pointer(N, h, subscripts, values);
        of_global(N);
        sum = sum * 7 + bound_in_header(&x, round);
        sum = sum * 7 + bound_of_a_function(&x);
        counter_given_away(N - round);
        apart(N, h);
        beside(N, counted, 5 + round);
        by_constants(N);
        sum = sum * 7 + beside_assertions(N / 10, first, s, h);
        sum = sum * 7 + bound_in_header(&x, N + 1);
    }
    printf("%ld %ld\n", sum, last_seen);
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(wide);
    CASE_PRINT(counted);
    return 0;
}
