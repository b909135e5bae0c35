/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Updates that do not commute: several operators on one array, functions of the old value, stores among
// updates, rounding at each step. Each element's owner executes them in the order of the loop.
// covers: row 22, row 23, row 27, row 28, row 39, row 41 of docs/constructs.md
#include <math.h>
#include <stdbool.h>

#include "case.h"

enum { N = 20000, M = 1200 };
static int s[N], r[N];
static double v[N], h[M + 7], g[M];
static unsigned u[M];
static int rounded[M], last[M];
static bool seen[M], odd[M];
static struct pair {
    double a;
    int count;
    double b;
} p[M];

static void operators(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[s[t]] += v[t];
        h[r[t]] *= 0.75;
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (t % 3)
            u[s[t]] |= 5u << (t & 15);
        else
            u[r[t]] ^= 3u << (t & 15);
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p[s[t]].a += v[t];
        p[r[t]].a *= 0.5;
        p[s[t]].b -= 1.0;
        p[r[t]].count++;
    }
}

static void functions(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] = v[t] - h[s[t]];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] = 0.5 * h[s[t]] + v[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] /= 1.0 + v[t] * v[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] = sqrt(fabs(h[s[t]]) + 1.0);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += 0.25 * h[s[t]];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        u[s[t]] <<= 1;
        u[r[t]] %= 1000003u;
        u[r[t]] = u[r[t]] * u[r[t]] + (unsigned)t;
    }
}

static void roundings(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        rounded[s[t]] += 2.5;
        seen[r[t]] |= t & 1;
        odd[s[t]] ^= t % 3 == 0;
    }
}

static void stores(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        g[t % M] = 0.5 * t;
        g[s[t]] += v[t];
        last[r[t]] = t;
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (g[r[t]] > 100.0)
            g[r[t]] = v[t];
}

static double table[2 * M];
static void two_names(int n) {
    double *other = table + 5;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        table[s[t]] += v[t];
        other[r[t]] = 2.0 * v[t];
    }
}

static void __attribute__((noinline)) two_pointers(double *x, double *y, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        x[s[t]] += v[t];
        y[r[t]] *= v[t];
    }
}

static double y[M];
static int start[M + 1], column[4 * M];
static void rows(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[i] = 0.0;
        for (int k = start[i]; k < start[i + 1]; k++)
            y[column[k]] += v[k];
    }
}

int main(void) {
    case_values(v, N);
    case_subscripts(column, 4 * M, M);
    for (int i = 0; i <= M; i++)
        start[i] = 4 * i - (i % 4);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        case_near_subscripts(r, N, M);
        operators(N);
        functions(N - round);
        roundings(N);
        stores(N);
        two_names(N);
        two_pointers(h, h + 7, N);
        two_pointers(h, g, N);
        rows(M);
        CASE_PRINT(h);
        CASE_PRINT(g);
        CASE_PRINT(u);
        CASE_PRINT(rounded);
        CASE_PRINT(seen);
        CASE_PRINT(odd);
        CASE_PRINT(last);
        CASE_PRINT(table);
        CASE_PRINT(y);
        for (int i = 0; i < M; i++) {
            case_print("a", &p[i].a, sizeof p[i].a);
            case_print("b", &p[i].b, sizeof p[i].b);
            case_print("count", &p[i].count, sizeof p[i].count);
        }
    }
    return 0;
}
