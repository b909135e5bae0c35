/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Comma expressions as statements: each operand counts as a separate statement, in macros too.
// covers: row 96 of docs/constructs.md
// INTEGERS: no
#include "case.h"

#define ADD(a, b) ((a).x += (b).x, (a).y += (b).y)
#define SUBTRACT(a, b) (a).x -= (b).x, (a).y -= (b).y
#define ADD_ONCE(a, b)           \
    do {                         \
        (a).x += (b).x, (a).y++; \
    } while (0)

typedef struct vector {
    double x, y;
} vector;
enum { N = 3000, ROWS = 100 };
static vector v[ROWS], w[N];
static double h[3 * ROWS + 3], g[ROWS], order[ROWS + 1], e[N];
static int k[N], own[N];

static void two_arrays(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += e[t], g[k[t]] -= e[t];
}

static void by_macros(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        ADD(v[k[t]], w[t]);
        ADD_ONCE(v[k[t]], w[t]);
        SUBTRACT(v[k[n - 1 - t]], w[t]);
    }
}

static void in_branches(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (e[t] > 0)
            SUBTRACT(v[k[t]], w[t]);
        else
            h[k[t]] += 1, g[k[t]] += 2;
}

static void with_own_values(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double m, q;
        m = e[t], q = m * 2;
        *(h + 3 * k[t]) += m, *(h + 3 * k[t] + 1) += q /* ; */;
    }
}

static double sums(int n) {
    double z = 0;
    int last = -1, i = 0;
    while (i < n) { // EXPECT: transformed
        z += e[i], h[k[i]] += 1;
        if (e[i] > 0.5)
            last = k[i], g[last] += 1;
        i++;
    }
    return z + last;
}

static void stored_first(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        own[t] = k[t] / 2, g[own[t]] += e[t];
}

static int last_values(int n) {
    int x = 0, i = 0, j = 0;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        x = k[t], h[x] += 1;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (k[t] > 5) {
            i = k[t], j = i + 1;
            h[j] += 1;
        }
    return x + 100 * i + 10000 * j;
}

static void order_kept(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        order[k[t]] /= 2.0, order[k[t] + 1] /= 3.0;
}

static void three(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            h[3 * k[t] + c] += e[t], g[k[t]] += 1, h[3 * k[t]] -= 0.5;
}

int main(void) {
    case_subscripts(k, N, ROWS);
    case_values(e, N);
    case_values(order, ROWS + 1);
    for (int i = 0; i < N; i++)
        w[i].x = case_value(), w[i].y = case_value();
    for (int round = 0; round < 4; round++) {
        two_arrays(N);
        by_macros(N);
        in_branches(N);
        with_own_values(N);
        stored_first(N);
        three(N);
        order_kept(N);
        printf("%a %d\n", sums(N - round), last_values(N));
    }
    CASE_PRINT(v);
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(own);
    CASE_PRINT(order);
    return 0;
}
