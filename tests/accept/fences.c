/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// DIRECTLY: 1 2 3 16 33
// INTEGERS: no
// METHODS: pseudo-expansion
// MAY-RUN-SERIALLY: expected where reads overlap updates
// Loops that are executed again with other subscripts. In some execution an iteration touches or reads memory that no
// iteration did before: up to there owners execute the iterations, from there one thread does (ownership/fences.h).
#include "case.h"

#include <string.h>

enum { N = 3000, M = 400, FAR = 50000000, SIDE = 48 };
static int all[4 * N], *const count = all, *const k = all + N, *const map = all + 2 * N;
static double values[6 * N], *const sum = values, *const other = values + 2 * N, *const x = values + 4 * N;
static int at[N], from[N], row[N + 1];
static double kept[N];

static void through_a_map(int n, int *c, const int *m, const int *s, int one) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        c[m[s[t]]] += one;
}

static void weighted(int n, double *b, const int *s, const double *w) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += w[t] * 1.25;
}

static void gathered(int n, double *b, const int *s, const double *w, const int *f) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += w[f[t]] * 1.25;
}

static void read_far(int n, double *b, const int *s, const double *w, const int *f) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] -= w[f[t]] * 0.75;
}

static void two(int n, double *b, double *c, const int *s, const int *f) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        b[s[t]] += (double)t / 3;
        c[f[t]] -= (double)t / 7;
    }
}

/* An iteration leaves values: its own element, and the last position. */
static int leaving(int n, double *b, const int *s, const double *w, double *own) {
    int last = -1;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        last = s[t];
        own[t] = w[t] / 3;
        b[last] += own[t];
    }
    return last;
}

static void in_rows(int n, double *b, const int *begin, const int *s, const double *w) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = begin[i]; j < begin[i + 1]; j++)
            b[s[j]] += w[j] * (i + 1);
}

static void windows(int n, double *g, const int *s, const double *w) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = s[t] % SIDE, top = s[t] / SIDE;
        for (int i = top; i < top + 3; i++)
            for (int j = left; j < left + 3; j++)
                g[i * SIDE + j] += w[t] / (1 + i - top);
    }
}

/* The window's updates decide where a second one is made. */
static void windows_and_more(int n, int *g, const int *m, const int *s) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int i = s[t]; i < s[t] + 3; i++)
            for (int j = 0; j < 3; j++)
                g[i * 4 + j] += FAR;
        g[m[m[s[t]]]] += 1;
    }
}

/* The same by a table that no pointer leads to: only what is read of s is compared. */
static const int table[8] = {3, 0, 2, 7, 5, 1, 4, 6};
static void windows_and_a_table(int n, int *g, const int *s, int left, int top) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int i = top + 50 * t; i < top + 50 * t + 3; i++)
            for (int j = left; j < left + 3; j++)
                g[i * 4 + j] += FAR;
        g[table[s[t]]] += 1;
    }
}

/* The first update of an inner iteration makes the subscript of the second one valid. */
static void by_the_first(int n, int *g, const int *s, int left) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int j = left; j < left + 3; j++) {
            g[200 * t + j] += FAR;
            g[200 * t + 20 + table[s[t]] + j] += 1;
        }
}

static void fill(void) {
    case_subscripts(at, N, M);
    case_subscripts(from, N, M);
    for (int t = 0; t < N; t++)
        row[t] = t < N / 2 ? 2 * t : N;
    row[N] = N;
    for (int t = 0; t < 4 * N; t++)
        all[t] = 0;
    for (int t = 0; t < N; t++)
        k[t] = 7 * t % N;
    case_subscripts(map, N, M);
    case_values(values, 6 * N);
    memset(kept, 0, sizeof kept);
}

/* One execution of each loop. stray: the iteration that leaves the arrays; N: none. */
static void each(int stray) {
    fill();
    const int later = stray < N / 2 ? N / 2 : 5;
    if (stray < N - 10) { /* makes a later subscript valid */
        map[k[stray]] = N + stray + later;
        k[stray + later] -= FAR;
    }
    through_a_map(N, count, map, k, FAR);
    fill();
    if (stray < N)
        at[stray] = (int)(x - sum) + (stray + 7) % N;
    weighted(N, sum, at, x);
    gathered(N, sum, at, x, from);
    CASE_PRINT(values);
    if (stray < N) {
        at[stray] = 3;
        from[stray] = (int)(sum - x) + at[(stray + 1) % N];
    }
    read_far(N, sum, at, x, from);
    if (stray < N)
        from[stray] = 3;
    two(N, sum, other, at, from);
    if (stray < N)
        at[stray] = (int)(other - sum) + from[(stray + 1) % N];
    two(N, sum, other, at, from);
    CASE_PRINT(values);
    if (stray < N)
        at[stray] = (int)(x - sum) + (stray + 7) % N;
    printf("%d\n", leaving(N, sum, at, x, kept));
    in_rows(N / 2 + 1, sum, row, at, x);
    windows(N, sum, at, x);
    CASE_PRINT(values);
    CASE_PRINT(kept);
    fill();
    for (int t = 0; t < N; t++)
        k[t] = t % 300;
    if (stray < N - 10) { /* the window updates map[k[stray]], which is invalid before */
        k[stray] = 2000;
        map[k[stray]] = 3 - FAR;
    }
    windows_and_more(N, all, map, k);
    CASE_PRINT(all);
    fill();
    for (int t = 0; t < N; t++)
        k[t] = t % 8;
    if (stray < N) /* the first window updates these, which are invalid before */
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                k[i * 4 + j] -= FAR;
    windows_and_a_table(20, map, k, 0, stray < N ? -N / 4 : 0);
    CASE_PRINT(all);
    fill();
    for (int t = 0; t < N; t++)
        k[t] = t % 8 - (stray < N && t < 3 ? FAR : 0);
    by_the_first(20, stray < N ? k : map, k, 0);
    CASE_PRINT(all);
}

/* The arrays are elsewhere, and overlap in the end. */
static void moved(void) {
    fill();
    for (int by = 0; by < 6; by++)
        weighted(N / 2, sum + 300 * by, at, x - 100 * by);
    CASE_PRINT(values);
    for (int by = 0; by < 3; by++)
        gathered(N / 2, sum + 100 * by, at, x, from);
    for (int by = 2; by >= 0; by--)
        gathered(N / 2, sum, at, sum + 200 * by, from);
    for (int by = 2; by >= 0; by--)
        two(N / 2, sum, sum + 200 * by, at, from);
    CASE_PRINT(values);
}

int main(void) {
    const int strays[] = {N, N, N, 1500, N, N, 0, N, N, N, N, N - 1, N, N, N, N, N, N, N, N, 129, N};
    for (unsigned i = 0; i < sizeof strays / sizeof *strays; i++)
        each(strays[i]);
    moved();
    moved();
    return 0;
}
