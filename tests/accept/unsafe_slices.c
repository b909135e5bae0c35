/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Conditions that make the subscripts' computation safe: they prevent loads out of bounds, divisions by zero,
// null pointers and far addresses. An inspector must execute only loads that the program executes.
// covers: row 52 of docs/constructs.md
#include "case.h"

enum { N = 9000, M = 600 };
static int at[N], map[M], divisor[N], ok[N];
static double w[N], h[M];

static void by_integer(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (ok[t])
            h[map[at[t]]] += w[t];
}

static void by_value(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (w[t] > 0.0)
            h[map[at[t]]] += w[t];
}

static void by_arithmetic(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (w[t] * 0.5 + w[t] > 0.0)
            h[map[at[t]]] += w[t];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double d = w[t] * w[t] * w[t];
        if (d <= 0.0)
            continue;
        h[map[at[t]]] -= d;
    }
}

static void by_continue(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (w[t] <= 0.0)
            continue;
        h[map[at[t]]] += w[t];
    }
}

static void by_and(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (ok[t] && map[at[t]] > 3)
            h[map[at[t]]] += 1.0;
}

static void by_conditional(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[ok[t] ? map[at[t]] : 0] += 1.0;
}

static void divided(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (divisor[t] != 0)
            h[M / divisor[t] % M] += w[t];
}

static void divided_by_value(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (w[t] > 0.0)
            h[M / divisor[t] % M] += w[t];
}

static void by_pointer(int n, const int *maybe) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (maybe)
            h[maybe[t]] += w[t];
}

static void far_away(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (w[t] > 0.0)
            h[at[t]] += w[t];
}

static void in_inner_loop(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int rounds = w[t] > 0.0 ? 2 : 0;
        for (int c = 0; c < rounds; c++)
            h[(map[at[t]] + c) % M] += w[t];
    }
}

int main(void) {
    case_values(w, N);
    for (int i = 0; i < M; i++)
        map[i] = (i * 7) % M;
    for (int round = 0; round < 3; round++) {
        for (int t = 0; t < N; t++) {
            ok[t] = w[t] > 0.0;
            at[t] = ok[t] ? case_below(M) : 2000000000;
            divisor[t] = ok[t] ? 1 + case_below(50) : 0;
        }
        by_integer(N);
        CASE_PRINT(h);
        by_arithmetic(N);
        by_value(N);
        CASE_PRINT(h);
        by_continue(N);
        CASE_PRINT(h);
        by_and(N);
        CASE_PRINT(h);
        by_conditional(N);
        CASE_PRINT(h);
        divided(N);
        CASE_PRINT(h);
        divided_by_value(N);
        CASE_PRINT(h);
        by_pointer(N, round == 1 ? NULL : divisor);
        CASE_PRINT(h);
        far_away(N);
        CASE_PRINT(h);
        in_inner_loop(N);
        CASE_PRINT(h);
    }
    return 0;
}
