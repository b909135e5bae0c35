/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Source text that a rewriting by names or by lines would break.
// covers: row 2, row 63, row 65, row 68 of docs/constructs.md
// CFLAGS: -Wno-comment
// COMPILERS: gcc clang-19
#include "case.h"
#include <string.h>

enum { N = 6000, M = 500 };
typedef struct grid {
    double *b;
    struct inner {
        double h[M];
        const int *s;
    } in[2];
} grid;

static int s[N];
static double w[N], h[M], b[M];

#define ARRAY h
#define SUBSCRIPT(x) s[x]
#define TWICE(x) ((x) + (x))
#define PLUS +=
#define BEGIN {
#define END }

static void shadows(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int k = s[t];
        h[k] += w[t];
        {
            double h = 0.25, t_h[2] = {h, 2.0 * h}; /* a local variable named like the array */
            int k = 1;
            b[s[t]] += h * t_h[k];
        }
        struct {
            double h;
        } b_ = {.h = w[t]};
        b[k] -= b_.h;
    }
}

static void by_macros(int n) {
    for (int t = 0; t < n; t++) BEGIN // EXPECT: transformed
        ARRAY[SUBSCRIPT(t)] PLUS TWICE(w[t]);
        b[s[t]] += TWICE(w[t]); /* h[s[t]] += 1; */ // h[s[t]] += 1; \
        h[s[t]] += 2;
    END
}

static void paths(grid *g, grid local, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        g->in[1].h[g->in[0].s[t]] += w[t];
        (*g).b[local.in[1].s[t]] += 0.5 * w[t];
    }
}

static void sizes(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[s[t]] += (double)(sizeof h / sizeof h[0]) - M + (double)sizeof(s[t]);
    }
}

static void texts(int n) {
    const char *name = "h[s[t]] += 1; }";
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const char brace = '{', quote = '"';
        h[s[t]] += name[t % 5] == brace || quote == '}' ? 1.0 : "} // h[0]"[1] + __LINE__;
    }
}

static void layout(int n)
{int t;for(t=0;t<n;t++)h[s[t]]+=w[t];t=n;for // EXPECT: transformed
(
int t = 0
;
t < n
;
t++
)
h
[
s
[t]
]
+=
w[t]
;}

static void functions(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += __func__[0] == 'f' ? 1.0 : 2.0;
}

static void types(int n) {
    typedef double real;
    enum kind { first, second } kind;
    _Bool is_odd;
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        typedef struct pair {
            real a, b;
        } pair;
        enum { factor = 3 };
        pair p = {w[t], factor};
        kind = s[t] % 2 ? second : first;
        is_odd = kind == second;
        h[s[t]] += is_odd ? p.a : p.b;
    }
}

/* redcc numbers equal member names (f, f_1): here the program has a member f_1. */
struct alike {
    double *f, *f_1;
};
static void alike(struct alike *p, struct alike *q, struct alike *r, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p->f[s[t]] += w[t];
        q->f[s[t]] -= w[t];
        r->f_1[s[t]] += w[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        r->f_1[s[t]] += w[t];
        p->f[s[t]] += w[t];
        q->f[s[t]] -= w[t];
    }
}

/* Parameters whose types are const-qualified. */
typedef double *const restrict target;
typedef double (*const rows)[2];
static void constants(const int n, const int *const k, const double *const restrict x,
                      const double (*const y)[2], target to, rows pairs, const rows *const all) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        to[k[t]] += x[t] * y[t / 2][t % 2];
        pairs[k[t] / 2][k[t] % 2] -= (*all)[1][0];
    }
}

int main(void) {
    static grid g;
    static double pairs[M / 2][2], of_f[2][M];
    struct alike p = {of_f[0], NULL}, q = {of_f[1], NULL}, r = {NULL, b};
    const rows all = (double(*)[2])g.in[1].h;
    g.b = b;
    g.in[0].s = g.in[1].s = s;
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        shadows(N);
        by_macros(N);
        paths(&g, g, N);
        sizes(N);
        texts(N);
        layout(N);
        functions(N);
        types(N);
        constants(N, s, w, (const double(*)[2])w, h, pairs, &all);
        CASE_PRINT(pairs);
        alike(&p, &q, &r, N);
        CASE_PRINT(of_f);
        CASE_PRINT(h);
        CASE_PRINT(b);
        case_print("in", g.in[0].h, sizeof g.in[0].h);
        case_print("in", g.in[1].h, sizeof g.in[1].h);
    }
    return 0;
}
