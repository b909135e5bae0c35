/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// DIRECTLY: 1 2 3 16 33
// INTEGERS: no
// MAY-RUN-SERIALLY: expected where reads overlap updates
// Sums in inner loops of loops that are executed again with other subscripts. In some execution an iteration touches or
// reads memory that no iteration did before. Up to there owners execute the iterations. From there one thread does, and
// later operands depend on its updates (ownership/fences.h).
#include "case.h"

#include <math.h>
#include <string.h>

enum { N = 3000, M = 400 };
static double values[6 * N], *const sum = values, *const x = values + 4 * N;
static int at[N], from[N], row[N + 1];
static float narrow, product = 1.25f; /* no update of a double changes them */
static long pairs;

static double in_rows(int n, double *b, const int *begin, const int *s, const double *w) {
    double total = 0.5;
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = begin[i]; j < begin[i + 1]; j++) {
            b[s[j]] += w[j] * (i + 1);
            total += w[j] * w[n - i];
        }
    return total;
}

/* Both ends of a pair are updated; a thread that owns neither skips the pair. */
static double half_list(int n, double *f, const int *begin, const int *s, const double *w) {
    double energy = 0;
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = begin[i]; j < begin[i + 1]; j++) {
            const int k = s[j];
            const double d = w[i] - w[n - 1 - j % n], rr = d * d + 0.25;
            if (rr > 1.5)
                continue;
            const double e = 1 / (rr * rr * rr) - 1 / rr;
            energy -= e * d;
            narrow += (float)e;
            pairs++;
            f[i] += e;
            f[k] -= e;
        }
    return energy;
}

/* Before the first iteration that leaves the arrays, no iteration has an operand. */
static void only_later(int n, double *b, const int *begin, const int *s, const double *w, double least) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = begin[i]; j < begin[i + 1]; j++) {
            b[s[j]] += 1.0;
            if (w[j] > least)
                product *= (float)(1 + 0x1p-9 * w[j]);
        }
}

/* The pointer `all` is null: it must not be dereferenced, because no iteration reaches the sum. */
static void never(int n, double *b, const int *begin, const int *s, const double *w, double least,
                  double *restrict all) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = begin[i]; j < begin[i + 1]; j++) {
            b[s[j]] += 1.0;
            if (w[j] > least)
                *all += w[j];
        }
}

/* An iteration leaves values: the sum, its own element, and the last position. */
static int leaving(int n, double *b, const int *begin, const int *s, const double *w, double *own, double *sums) {
    int last = -1;
    double total = *sums;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        last = s[i];
        own[i] = own[i] * 0.5 + w[i];
        for (int j = begin[i]; j < begin[i + 1]; j++) {
            b[s[j]] += own[i];
            total += sqrt(own[i] + 0.99);
        }
    }
    *sums = total;
    return last;
}

static void fill(void) {
    case_subscripts(at, N, M);
    case_subscripts(from, N, M);
    for (int t = 0; t < N; t++)
        row[t] = t < N / 2 ? 2 * t : N;
    row[N] = N;
    case_values(values, 6 * N);
}

/* One execution of each loop. stray: the iteration that updates x; N / 2: none. */
static void each(int stray, double *own) {
    double sums = 2.5;
    fill();
    if (stray < N / 2)
        at[2 * stray] = (int)(x - sum) + (stray + 7) % N;
    printf("%a\n", in_rows(N / 2, sum, row, at, x));
    printf("%a\n", half_list(N / 2, sum, row, at, x));
    printf("%a %ld\n", (double)narrow, pairs);
    CASE_PRINT(values);
    fill();
    if (stray < N / 2)
        for (int t = 0; t < 9; t++)
            at[2 * stray + t % 2] = (int)(x - sum) + 2 * stray + 20 + t;
    only_later(N / 2, sum, row, at, x, 1.0);
    printf("%a\n", (double)product);
    never(N / 2, sum, row, at, x, 1e9, NULL);
    printf("%d\n", leaving(N / 2, sum, row, at, x, own, &sums));
    printf("%a\n", sums);
    CASE_PRINT(values);
}

int main(void) {
    static double own[N];
    const int none = N / 2;
    const int strays[] = {none, none, none, 700, none, none, 0, none, none, none, none, none - 12, none,
                          none, none, none, none, none, none, none, 129, none, none, 64, none};
    for (unsigned i = 0; i < sizeof strays / sizeof *strays; i++)
        each(strays[i], own);
    CASE_PRINT(own);
    return 0;
}
