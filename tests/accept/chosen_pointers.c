/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A pointer that is set once, before the loop, to one of several arrays: where the loop reads an array to which it may
// point, the guard decides.
// covers: row 29, row 30 of docs/constructs.md
// MAY-RUN-SERIALLY: in some calls the arrays overlap
#include "case.h"

enum { N = 9000, M = 900 };
struct cell {
    double sum, x;
};
struct fields {
    double *field[2];
    int current;
};
static int s[N], r[N];
static double v[N], first[M], second[M];
static struct cell cells[M], others[M];

static void one_of_two(int n, double *f, double *g, int flag) {
    double *dst = flag ? f : g;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        dst[s[t]] += v[t];
}

static void set_later(int n, double *f, double *g, int flag) {
    double *dst;
    dst = flag ? f : g;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        dst[s[t]] += v[t];
        dst[r[t]] -= v[t];
    }
}

static void one_is_read(int n, double *f, double *g, int flag) {
    double *dst = flag ? f : g;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        dst[s[t]] += f[r[t]] < 0.0 ? 1.0 : -0.5;
}

static void one_is_updated_too(int n, double *f, double *g, int flag) {
    double *dst = (flag ? f : g) + 1;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        dst[s[t] / 2] += v[t];
        g[r[t]] *= -1.0;
    }
}

/* The choice gives away the pointer f, so that `restrict` says nothing about dst. */
static void one_is_restricted(int n, double *restrict f, double *restrict g, int flag) {
    double *dst = flag ? f : g;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        dst[s[t]] += f[r[t]] < 0.0 ? 1.0 : -0.5;
}

static double of_local_arrays(int n, int flag) {
    double near[M] = {0}, far[M] = {0}, sum = 0;
    double *const dst = flag ? near : far;
    for (int i = 0; i < M; i++)
        near[i] = far[i] = v[i];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        dst[s[t]] += near[r[t]] < 0.0 ? 1.0 : -0.5;
    for (int i = 0; i < M; i++)
        sum += near[i] - 2.0 * far[i];
    return sum;
}

static void by_one_more_pointer(int n, double *f, double *g, int flag) {
    double *dst = flag ? f : g, *moved = dst + 2;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *element = &moved[s[t] / 2];
        *element += g[r[t]] < 0.0 ? 1.0 : -0.5;
    }
}

static void of_fields(int n, struct fields *x) {
    double *dst = x->current ? x->field[1] : x->field[0];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        dst[s[t]] += v[t];
}

static void of_records(int n, int flag) {
    struct cell *c = flag ? cells : others;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        c[s[t]].sum += cells[r[t]].x;
}

static void unless_null(int n, double *f, double *g) {
    double *dst = f ? f : g;
    if (!dst)
        return;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        dst[s[t]] += v[t];
}

static void sources(int n, double *f, int flag) {
    const double *from = flag ? v : f;
    const int *at = flag ? s : r;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        f[at[t]] += from[t % M];
}

static void show(void) {
    CASE_PRINT(first);
    CASE_PRINT(second);
    CASE_PRINT(cells);
    CASE_PRINT(others);
}

int main(void) {
    for (int round = 0; round < 4; round++) {
        const int flag = round & 1;
        struct fields x = {{first, second}, flag};
        case_values(v, N);
        case_values(first, M);
        case_values(second, M);
        case_subscripts(s, N, M);
        case_subscripts(r, N, M);
        for (int i = 0; i < M; i++)
            cells[i].x = case_value();
        one_of_two(N, first, second, flag);
        set_later(N, first, second, flag);
        one_is_read(N, first, second, flag);
        show();
        one_is_updated_too(N, first, second, flag);
        one_is_restricted(N, first, second, flag);
        show();
        const double sum = of_local_arrays(N, flag);
        case_print("sum", &sum, sizeof sum);
        by_one_more_pointer(N, first, second, flag);
        of_fields(N, &x);
        of_records(N, flag);
        unless_null(N, flag ? first : NULL, second);
        show();
        sources(N, first, flag);
        show();
    }
    return 0;
}
