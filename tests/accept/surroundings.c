/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Places where a loop may be: after if and else, under a label, in a loop or a switch, next to macros, in
// nested blocks, among names that shadow others, two loops on one line.
// covers: row 4, row 67, row 68, row 2 of docs/constructs.md
#include "case.h"

enum { N = 8000, M = 600 };
static int s[N];
static double w[N], h[M], g[M];

#define SCALE(v) ((v)*0.5)
#define UPDATE(array, at, v)                                                                       \
    do {                                                                                           \
        (array)[(at)] += (v);                                                                      \
    } while (0)

static void branches(int which, int n) {
    int t;
    if (which == 0)
        for (t = 0; t < n; t++) // EXPECT: transformed
            h[s[t]] += w[t];
    else if (which == 1)
        for (t = 0; t < n; t++) // EXPECT: transformed
            h[s[t]] -= w[t];
    else
        for (t = 0; t < n; t++) // EXPECT: transformed
            g[s[t]] += w[t];
}

static void outer(int n) {
    int steps = 0;
    do {
        for (int t = 0; t < n; t++) // EXPECT: transformed
            h[s[t]] += SCALE(w[t]) * steps;
    } while (++steps < 3);
    switch (steps) {
    case 3:
        for (int t = 0; t < n; t++) // EXPECT: transformed
            g[s[t]] += 0.25 * w[t];
        break;
    default:
        break;
    }
}

static void labelled(int n) {
    int again = 2;
repeat:
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += w[t];
    if (--again > 0)
        goto repeat;
}

static void macros(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        UPDATE(h, s[t], w[t]);
        UPDATE(g, s[t], SCALE(w[t]));
    }
}

static inline void shadowed(double *redcc, int n) {
    double *const owner = redcc;
    for (int base = 0; base < n; base++) { // EXPECT: transformed
        const int t = s[base];
        {
            const double t_ = w[base], n_ = t_ * 2.0;
            owner[t] += n_;
        }
    }
}

static void one_line(int n) {
    /* clang-format off */
    for (int t = 0; t < n; t++) { h[s[t]] += w[t]; } for (int t = 0; t < n; t++) g[s[t]] -= w[t]; // EXPECT: transformed
    /* clang-format on */
}

int main(void) {
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        branches(round, N);
        outer(N);
        labelled(N - 1);
        macros(N);
        shadowed(g, N);
        one_line(N);
        CASE_PRINT(h);
        CASE_PRINT(g);
    }
    return 0;
}
