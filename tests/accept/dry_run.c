/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// As far as the analysis knows, the slice may read an array that the loop updates. A dry run records all
// iterations in order before the inspection. Arrays are disjoint in some calls and overlap in others.
// MAY-RUN-SERIALLY: in some calls the arrays overlap
#include "case.h"

#include <string.h>

enum { N = 6000, M = 500 };
static int h[N + 1], k[N], map[N], row[N + 1], column[3 * N], by[N];
static long to[M], weight[N], deep[N];

static void through_a_map(int n, int *count, const int *m, const int *at, int one) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        count[m[at[t]]] += one;
}

static void through_two(int n, int *count, const int *m, const int *far, const int *at) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        count[m[far[at[t]]]] += 1;
}

static void in_rows(int n, int *count, const int *begin, const int *of, int one) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = begin[i]; j < begin[i + 1]; j++)
            count[of[j]] += one;
}

static void where_it_is_positive(int n, long *sum, const int *at, const long *w, const long *m) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (w[t] > 0)
            sum[at[t]] += m[at[t]];
}

static void one_by_another(int n, int *count, const int *s, const int *add, const int *divisor,
                           long *sum) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        count[s[t]] += add[t];
        sum[(t + 100) / divisor[t] % M] += t;
    }
}

/* The slice cannot be a separate function here, since the loop leaves the value `last`. */
static int in_place(int n, int *count, const int *m, const int *at, int one) {
    int last = -1;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (at[t] < 0)
            continue;
        last = m[at[t]];
        count[last] += one;
    }
    return last;
}

static void apart(void) {
    case_subscripts(k, N, N);
    case_subscripts(map, N, M);
    case_subscripts(column, 3 * N, M);
    for (int t = 0; t < N; t++) {
        row[t] = 3 * t;
        by[t] = t % 9 + 1;
        weight[t] = t % 5 - 2;
        deep[t] = t;
    }
    row[N] = 3 * N;
    through_a_map(N, h, map, k, 3);
    through_two(N, h, map, k, k);
    in_rows(N, h, row, column, 2);
    where_it_is_positive(N, to, map, weight, deep);
    one_by_another(N, h, k, by, by, to);
    printf("%d\n", in_place(N, h, map, k, 7));
    CASE_PRINT(h);
    CASE_PRINT(to);
}

/* Without the updates of earlier iterations, each subscript is out of bounds. */
static void not_apart(void) {
    const int far = 1000000000;
    for (int t = 0; t < N; t++) {
        k[t] = t == 0 ? 0 : t - far;
        map[t] = t + 1;
        row[t] = t < 2 ? t : t - far;
        column[t] = t + 2;
    }
    through_a_map(N - 1, k, map, k, far);
    in_rows(N - 2, row, row, column, far);
    CASE_PRINT(k);
    CASE_PRINT(row);
    for (int t = 0; t < N; t++)
        k[t] = t == 0 ? 0 : t - far;
    printf("%d\n", in_place(N - 1, k, map, k, far));
    CASE_PRINT(k);
    memset(h, 0, sizeof h);
    for (int t = 0; t < N; t++)
        k[t] = t;
    one_by_another(N, h, k, by, h, to);
    for (int t = 0; t < N; t++)
        k[t] = t % M;
    where_it_is_positive(M, to, k, to, to);
    CASE_PRINT(to);
}

int main(void) {
    apart();
    not_apart();
    return 0;
}
