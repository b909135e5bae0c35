/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Branches that are never executed, because of a constant or a function that always returns one value. Messages, exits,
// jumps and local variables in them do not matter. Elements are written as sums of pointers.
// INTEGERS: no
// covers: row 98 of docs/constructs.md

#include <stdbool.h>
#include <string.h>

#include "case.h"

enum { N = 6000, M = 700, K = 4, VERBOSE = 0 };
#define DEBUG 0
#define CHECK(call)                                                                                                    \
    do {                                                                                                               \
        int failed_ = !(call);                                                                                         \
        if (failed_) {                                                                                                 \
            fprintf(stderr, "%s: %d\n", #call, messages++);                                                            \
            exit(1);                                                                                                   \
        }                                                                                                              \
    } while (0)
static int s[N * K], messages;
static double a[K * K], v[N], h[M], f[M][3];

/* C (n, m) of A (n, p) and B (p, m) */
static int product(double *c, double *x, double *y, int n, int m, int p) {
    memset(c, 0, n * m * sizeof(double));
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++)
            for (int k = 0; k < p; k++)
                *(c + m * i + j) += *(x + p * i + k) * *(y + m * k + j);
    return 1;
}

static bool product_with_message(double *c, double *x, double *y, int n) {
    const int done = product(c, x, y, n, 1, n);
    if (done != 1)
        puts("no product");
    return done == 1 ? true : true;
}

static int fails_never(double *c, double *y) {
    if (!product_with_message(c, a, y, K))
        return -1;
    if (DEBUG)
        return -2;
    for (int k = 0; k < K; k++)
        c[k] = 0.5 * c[k];
    return 0;
}

__attribute__((noipa)) static void assembled(int n, const char *title) {
    int dof[K], check;
    double u[K], p[K];
    for (int t = 0; t < n; ++t) { // EXPECT: transformed
        for (int j = 0; j < K; ++j)
            *(dof + j) = *(s + K * t + j);
        for (int j = 0; j < K; ++j)
            *(u + j) = *(v + *(dof + j));
        check = product(p, a, u, K, 1, K);
        if (!check)
            printf("%s: problems in %d\n", title, t);
        for (int j = 0; j < K; ++j)
            *(h + *(dof + j)) += *(p + j);
    }
}

__attribute__((noipa)) static int by_status(int n, const char *title) {
    int status = 7, last = -1;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double u[K] = {v[t], 1.0, -v[t], 0.5}, p[K];
        if ((status = fails_never(p, u)) < 0) {
            last = t;
            printf("%s\n", title);
            goto fail;
        } else if (status > 0)
            return t;
        for (int j = 0; j < K; j++)
            *(*(f + s[K * t + j]) + j % 3) += p[j];
    }
    return status;
fail:
    return last;
}

__attribute__((noipa)) static void by_macro(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double u[K] = {1.0, v[t], 2.0, 0.25}, p[K];
        CHECK(product_with_message(p, a, u, K));
        for (int j = K - 1; j >= 0; j--)
            *(h + s[K * t] - 1 + (s[K * t] == 0)) -= p[j];
    }
}

__attribute__((noipa)) static int by_constant(int n) {
    int seen = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (VERBOSE && t % 100 == 0)
            printf("iteration %d\n", t);
        if (DEBUG > 1) {
            static int calls;
            fprintf(stderr, "%d %g\n", ++calls, v[t]);
        }
        h[s[K * t]] += v[t];
        if (sizeof(int) && !DEBUG)
            seen = t;
        else
            exit(2);
    }
    return seen;
}

/* `again` passes the result of one dead branch to a condition in another block. */
__attribute__((noipa)) static void in_blocks(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double u[K] = {0.0, v[t], 1.0, 2.0}, p[K];
        int ok = product(p, a, u, K, 1, K), again = 0;
        if (!ok)
            again = 1;
        if (v[t] > 0) {
            if (again || !ok)
                abort();
            (f + s[K * t])[0][1] += p[1];
        }
        h[s[K * t + 1]] *= 1.0 + 1e-3 * p[2];
    }
}

int main(void) {
    case_subscripts(s, (long)N * K, M);
    case_values(a, (long)K * K);
    case_values(v, N);
    case_values(h, M);
    case_values(f[0], 3 * M);
    assembled(N, "assembled");
    const int status = by_status(N, "status");
    by_macro(N);
    const int seen = by_constant(N);
    in_blocks(N);
    printf("%d %d %d\n", status, seen, messages);
    case_print("h", h, sizeof h);
    case_print("f", f, sizeof f);
    return 0;
}
