/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The example of docs/generated-code.md in a program, in the form that redcc generates but without
 * binning. `springs N CALLS` prints a checksum of the result's bits, which must equal the serial
 * loop's. A further argument makes it print the least trip count for which loops of short
 * iterations call the runtime. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if !defined(REDCC_OFF) && defined(__has_include)
#if __has_include(<redcc/runtime.h>)
#include <redcc/runtime.h>
REDCC_REQUIRE_VERSION(1);
#ifdef SPRINGS_LEAVE_OUT /* a wrong update, which REDCC_VALIDATE must detect */
#define redcc_is_owned(worker, owner, address) ((void)(owner), 0)
#endif
#endif
#endif
#ifndef REDCC_RUNTIME_H
#define REDCC_OVER(redcc_site)
#endif
#if defined(__clang__)
#pragma clang fp contract(off)
#elif defined(__FP_FAST_FMA)
#pragma GCC optimize("fp-contract=off")
#endif

struct system {
    double (*b)[3];
};

static void spring(const double (*x)[3], int i, int j, double *f) {
    int c;
    for (c = 0; c < 3; c++)
        f[c] = 0.7 * (x[j][c] - x[i][c]) - 0.1;
}

/* clang-format off */
#ifdef REDCC_RUNTIME_H
REDCC_QUIET_BEGIN
static const redcc_array redcc__arrays_springs[] = {{"s->b", REDCC_SUM, REDCC_DOUBLE, sizeof(double), sizeof(double[3]), 0}};
static const redcc_source redcc__sources_springs[] = {{"edge", 1}, {"x", 0}};
static redcc_site redcc__site_springs = {{{"springs.c", 4, "springs", REDCC_ORDER_SERIAL, REDCC_VERIFIABLE | REDCC_SELECTS, 1, redcc__arrays_springs, 2, redcc__sources_springs, 3, 0}, 0, 0, 0}, 0};
struct redcc__context_springs {
    REDCC_PROGRESSIONS_OF(2);
    __typeof__(const int (*)[2]) edge;
    __typeof__(const double (*)[3]) x;
    struct system *s;
};
REDCC_SLICE redcc__slice_springs(REDCC_SLICE_PARAMETERS, int t, const int (*edge)[2], const double (*x)[3], struct system *s) {
    int i, j;
    i = edge[t][0]; j = edge[t][1];
    REDCC_READ_ROW(1, x, j); REDCC_READ_ROW(1, x, i); REDCC_TOUCH_ROW(0, s->b, i); REDCC_TOUCH_ROW(0, s->b, j); }
REDCC_BODY redcc__body_springs(REDCC_BODY_PARAMETERS_1, int t, double (*redcc__to_b)[3], const int (*edge)[2], const double (*x)[3]) {
    int i, j;
    double f[3];
    {
        i = edge[t][0];
        j = edge[t][1];
        spring(x, i, j, f);
        for (int c = 0; c < 3; c++) {
            { REDCC_UPDATE(0, &redcc__to_b[i][c]) redcc__to_b[i][c] += f[c]; }
            { REDCC_UPDATE(0, &redcc__to_b[j][c]) redcc__to_b[j][c] -= f[c]; }
        }
    }
}
REDCC_MEMBER redcc__member_springs(REDCC_MEMBER_PARAMETERS) {
    REDCC_BEGIN(redcc__context_springs);
    __typeof__(const int (*)[2]) edge = redcc__context->edge;
    __typeof__(const double (*)[3]) x = redcc__context->x;
    struct system *s = redcc__context->s;
    REDCC_PARALLEL(REDCC_CHUNK_1,
        redcc__slice_springs(REDCC_SLICE_ARGUMENTS, REDCC_COUNTER(int, redcc__k), edge, x, s),
        redcc__body_springs(REDCC_BODY_ARGUMENTS_1, REDCC_COUNTER(int, redcc__k), redcc__base_0, edge, x))
}
REDCC_QUIET_END
#endif
static void springs(int n, const int (*edge)[2], const double (*x)[3], struct system *s) {
    int t, i, j;
    double f[3];
    { /* redcc: in parallel, with the bits of the sequential loop: s->b (+) */
#ifdef REDCC_RUNTIME_H
    REDCC_QUIET_BEGIN
    REDCC_COUNT_UP(0, (redcc_int)n);
    int redcc__done = 0;
    if (REDCC_IS_WORTH(redcc__site_springs, redcc__trip)) {
        REDCC_ATTEMPT(redcc__context_springs, 1, 2, 3);
        REDCC_BASE(0, s->b);
        REDCC_KEY(1, (redcc_size)edge);
        REDCC_KEY(2, (redcc_size)s);
        redcc__known[1].first = (const char *)x; /* x[i]: the inspector finds the range */
        REDCC_FIRST_AND_LAST { int t = (int)REDCC_FIRST_OR_LAST(1); REDCC_KNOWN_ROW(0, edge[t]); }
        redcc__context.edge = edge;
        redcc__context.x = x;
        redcc__context.s = s;
        redcc__done = REDCC_EXECUTED(redcc__site_springs, redcc__member_springs);
    }
    REDCC_QUIET_END if (redcc__done) {
        t = (__typeof__(t))redcc__final; /* the counter is used after the loop */
    } else
#endif
    for (t = 0; t < n; t++) {
        i = edge[t][0];
        j = edge[t][1];
        spring(x, i, j, f);
        for (int c = 0; c < 3; c++) {
            s->b[i][c] += f[c];
            s->b[j][c] -= f[c];
        }
    } REDCC_OVER(redcc__site_springs) }
    if (t != n)
        abort();
}
/* clang-format on */

int main(int count, char **arguments) {
    const int nodes = count > 1 ? atoi(arguments[1]) : 1000;
    const int calls = count > 2 ? atoi(arguments[2]) : 3;
    const int n = 3 * nodes;
    int(*edge)[2] = malloc(sizeof(int[2]) * (size_t)n);
    double(*x)[3] = calloc((size_t)nodes, sizeof(double[3]));
    struct system s = {calloc((size_t)nodes, sizeof(double[3]))};
    unsigned long sum = 0;
    for (int t = 0; t < n; t++) {
        edge[t][0] = t / 3;
        edge[t][1] = (t / 3 + 1 + t % 3 * 7) % nodes;
    }
    for (int i = 0; i < nodes; i++)
        for (int c = 0; c < 3; c++)
            x[i][c] = 0.37 * i + 1.0 / (c + i + 1);
    for (int call = 0; call < calls; call++)
        springs(n, (const int(*)[2])edge, (const double(*)[3])x, &s);
    for (int i = 0; i < nodes; i++)
        for (int c = 0; c < 3; c++) {
            unsigned long bits;
            memcpy(&bits, &s.b[i][c], sizeof bits);
            sum = (sum ^ bits) * 0x9e3779b97f4a7c15u;
        }
    printf("%016lx\n", sum);
#ifdef REDCC_RUNTIME_H
    if (count > 3 && redcc__site_springs.calls) {
        const redcc_calls *calls = redcc__site_springs.calls;
        printf("%lld unasked, from %lld\n", (long long)redcc_exempt_iterations,
               (long long)*calls->least_trip);
    }
#endif
    free(edge);
    free(x);
    free(s.b);
    return 0;
}
