/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The iteration's own element is read and then stored to. The stores are made after all iterations.
// covers: row 93 of docs/constructs.md
#include "case.h"

enum { N = 12000, M = 900 };
static int at[N + 1], mark[N], count[M];
static double weight[N], h[M], temporary[N + M], zero;
static float single[N + M];

static void to_zero(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i];
        t[i] = 0;
    }
}

/* The form that a supernodal factorisation has. */
static void to_nothing(int n, int from, int begin, const int *sub, double *dense, double *all) {
    const double nothing = 0.0;
    double *part = &all[begin];
    int i, row;
    for (i = 0; i < n; ++i) { // EXPECT: transformed
        row = sub[from];
        dense[row] -= part[i];
        part[i] = nothing;
        from++;
    }
    zero += i + from;
}

static void by_factors(int n, const int *r, double *y, double *t, float factor) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] += t[i] * t[i];
        t[i] *= factor;
    }
}

static void downwards(long n, int c, const int *r, double *y, float *t) {
    for (long i = n; i > 0; i--) { // EXPECT: transformed
        y[r[i - 1]] += t[i - 1 + c];
        t[i - 1 + c] = -1;
    }
    unsigned k = 0;
    while (k < (unsigned)n) { // EXPECT: transformed
        y[r[k]] -= t[k];
        t[k] += 0.5f;
        k += 3;
    }
}

static void under_conditions(int n, const int *r, double *y, double *t, int limit) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        if (t[i] != 0.0 && i != limit) {
            y[r[i]] -= t[i];
            t[i] = 0;
        }
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        if (t[i] < 0.5)
            y[r[i]] += 1;
        if (i > limit)
            t[i] = -0.0;
    }
}

/* The stored values are the subscripts of the next execution. */
static void of_marks(int n, int *restrict m, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        c[m[i]]++;
        m[i] = 1;
    }
}

static void several(int n, const int *r, double *y, double *t, float *restrict s) {
    double all = 0;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const double v = t[i] + s[i];
        if (v > 0.25) {
            y[r[i]] += v;
            y[r[i + 1]] -= v * 0.5;
        }
        all += v;
        s[i] = 2;
        t[i] = 1;
        s[i] = 3;
        if (i & 1) {
            t[i] = 7;
        }
    }
    zero += all;
}

static void refill(int round) {
    for (int i = 0; i < N + M; i++) {
        temporary[i] = i % 5 == round % 5 ? 0.0 : weight[(i * 7 + round) % N];
        single[i] = (float)temporary[i];
    }
}

int main(void) {
    case_values(weight, N);
    case_subscripts(mark, N, M);
    for (int round = 0; round < 6; round++) {
        if (round % 3 == 0)
            case_subscripts(at, N + 1, M - 20);
        const int n = round == 3 ? 5000 : N;
        refill(round);
        to_zero(n, at, h, temporary);
        CASE_PRINT(temporary);
        refill(round + 1);
        to_nothing(n - 40, 30, round, at, h, temporary);
        CASE_PRINT(temporary);
        refill(round + 2);
        by_factors(n, at, h, temporary, 0.5f);
        downwards(n, round, at, h, single);
        CASE_PRINT(single);
        under_conditions(n, at, h, temporary, n / 2);
        CASE_PRINT(temporary);
        of_marks(n, mark, count);
        if (round % 2 == 0)
            case_subscripts(mark, N, M);
        refill(round + 3);
        several(n, at, h, temporary, single);
        CASE_PRINT(temporary);
        CASE_PRINT(single);
        CASE_PRINT(h);
        CASE_PRINT(count);
        CASE_PRINT(mark);
    }
    printf("%a\n", zero);
    return 0;
}
