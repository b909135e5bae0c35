/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Variables other than the counter that a loop header sets: by chained assignments, one after the other, or in a
// declaration. Some are secondary counters, some are unused in the loop, some are sums or minima.
// covers: row 94 of docs/constructs.md
#include "case.h"

enum { N = 3000, ROWS = 90 };
static int s[3 * N + 9];
static double e[3 * N + 9], h[ROWS];
static long counted[ROWS];

static int chained(int n) {
    int ii, jj;
    for (ii = jj = 0; ii < n; ii++, jj += 2) // EXPECT: transformed
        h[s[ii]] += e[jj] * e[jj + 1];
    return ii + jj;
}

static long chained_widths(int n) {
    int i;
    long q;
    short r;
    unsigned char unused;
    for (q = i = r = unused = 7; i < n; i++, q += 3, --r) { // EXPECT: transformed
        h[s[i]] += e[q] * r;
        unused = 0;
    }
    return 100 * q + i;
}

static int chained_bound(int first, int n) {
    int i, j, end;
    for (j = i = first, end = n; i < end; ++i, j += 2) { // EXPECT: transformed
        const double w = e[j];
        h[s[i]] += w;
    }
    return i + 7 * j;
}

static void declared(int n) {
    for (int i = 0, j = 3; i < n; i++, j += 2) // EXPECT: transformed
        h[s[j]] += e[i];
}

static void declared_down(int n, const int by) {
    for (int i = n - 1, j = 2 * n, last = 1; i >= last; i--, j -= by) // EXPECT: transformed
        h[s[i]] -= e[j];
}

static void declared_pointers(int n) {
    for (const double *p = e, *q = e + 5, *end = e + n; p < end; p++, q += 2) // EXPECT: transformed
        h[s[p - e]] += *p * *q;
}

static void declared_and_read(int n) {
    for (int i = 0, m = n / 2; i < n; i++) // EXPECT: transformed
        h[s[i]] += i < m ? e[i] : e[m];
}

static void declared_bound_that_is_read(int n) {
    for (int i = 0, last = n - 1; i <= last; i++) // EXPECT: transformed
        h[s[i]] += e[last - i];
}

static void declared_and_dead(int n) {
    for (int i = 0, k = 0; i < n; i++) { // EXPECT: transformed
        k = s[i] / 2;
        counted[k] += s[k];
    }
}

static double dead(int n) {
    int i, k;
    double w;
    for (i = 0, k = 0, w = 0.5; i < n; i++) { // EXPECT: transformed
        k = s[i] / 3;
        w = e[i] * 2;
        h[k] += w;
    }
    return w + k;
}

static long sum(int n, int from) {
    int i;
    long c;
    for (i = 0, c = from; i < n; i++) { // EXPECT: transformed
        h[s[i]] += e[i];
        c += s[i];
    }
    return c;
}

static double sum_of_floats(int n) {
    int i;
    double total;
    for (total = i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] += e[i];
        total += e[i] * 3;
    }
    return total;
}

static double largest(int n) {
    int i, at;
    double w;
    for (i = 0, w = -5, at = -1; i < n; i++) { // EXPECT: transformed
        if (e[i] > w) {
            w = e[i];
            at = i;
        }
        counted[s[i]]++;
    }
    return w + at;
}

static int sometimes(int n, int k) {
    int i;
    for (i = 0, k = 77; i < n; i++) { // EXPECT: transformed
        if (e[i] > 0.99) {
            k = s[i];
            counted[k]++;
        }
    }
    return k;
}

int main(void) {
    case_subscripts(s, 3 * N + 9, ROWS);
    case_values(e, 3 * N + 9);
    for (int round = 0; round < 12; round++) {
        const int n = round == 5 ? 0 : round == 6 ? 1 : N;
        printf("%d %ld %d %a %ld %a", chained(n), chained_widths(n), chained_bound(round, n),
               dead(n), sum(n, round), sum_of_floats(n));
        printf(" %a %d\n", largest(n), sometimes(n, round));
        declared(n);
        declared_down(n, 1 + round / 6);
        declared_pointers(n);
        declared_and_read(n);
        declared_bound_that_is_read(n);
        declared_and_dead(n);
    }
    CASE_PRINT(h);
    CASE_PRINT(counted);
    return 0;
}
