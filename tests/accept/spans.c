/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Inner loops that step through rows: the inspector records a row's first and last element at once.
// covers: row 47, row 48 of docs/constructs.md
#include "case.h"
#include <stddef.h>

enum { N = 4000, K = 11, W = 34, M = 5000 };
static int cluster[N], start[N + 1], size_of[K], last_seen[M], odd[N];
static float feature[N][W], *feature_row[N], centre[K][W], flat[K * W];
static double y[M], x[M], z[M + 8];
static long counts[M];

static void k_means(int n, int m, float **rows, float (*c)[W], int *length) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        int k = cluster[i];
        length[k]++;
        for (int j = 0; j < m; j++)
            c[k][j] += rows[i][j];
    }
}

/* The counter is declared before the loop, and its value after the loop is a subscript. */
static void counter_used_after(int n, int m, float *restrict c, const float *restrict f) {
    int i, j;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        int k = cluster[i];
        for (j = 2; j <= m; ++j)
            c[k * W + (j - 1)] += f[i * W + j - 2];
        last_seen[(j * 7 + i) % M]++;
    }
}

/* Segments of any length, some of them empty, whose bounds a table gives. */
static void segments(int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int p = start[i]; p < start[i + 1]; p++)
            y[p % M == p ? p : 0] += x[i % M]; /* not known to be consecutive */
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (size_t p = (size_t)start[odd[i]]; p < (size_t)start[odd[i] + 1]; p++)
            y[p] += x[i % M] * (double)p;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int first = start[odd[i]], count = start[odd[i] + 1] - first;
        for (int p = 0; p < count; p++) {
            y[first + p] -= x[i % M];
            z[p + first + 3] += x[p] > 0 ? 1 : 0.5;
        }
    }
}

/* Unsigned sums may wrap around, so the elements may not be consecutive: 4294967295 + 1 is 0 here. */
static void unsigned_sums(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const unsigned before = (unsigned)(odd[i] % 5) - 3u;
        for (unsigned p = 3; p < 9; p++)
            z[before + p] += x[i % M];
    }
}

/* Inner loops with jumps, conditions, steps of two, downward steps, and rows of rows. */
static void others(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        for (int p = 0; p < 7; p++) {
            if (x[(i + p) % M] > 0.5)
                continue;
            counts[odd[i] + p]++;
        }
        for (int p = 0; p < i % 5; p += 2)
            counts[odd[i] / 2 + p] += 3;
        for (int p = i % 4; p > 0; p--)
            counts[odd[i] / 3 + p]--;
        for (long p = odd[i] % 7; p < 9 && p < 12; p++)
            counts[odd[i] / 3 + p] += p;
        for (int q = 0; q < 2; q++)
            for (int p = 0; p < 3 + q; p++)
                counts[odd[i] / 4 + q * 100 + p] ^= q + p;
    }
}

static void through_pointers(int n, double *out, double **rows, int m) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = 0; j < m; j++)
            out[odd[i] + j] += rows[i][j];
}

/* Steps of more than one: the updates of a turn fill the gap to the next turn, or leave rows out. */
static void by_steps(int n, double *out) {
    int i, p, q;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        double *at = out + odd[i] % 90;
        for (p = odd[i] / 2; p < odd[i] / 2 + i % 8; p += 3) {
            counts[p] += i;
            counts[p + 1] ^= p;
            counts[p + 2]--;
        }
        last_seen[p % M]++;
        for (q = 1; q <= i % 6; at += 2, q += 2) {
            at[0] += x[q];
            at[1] -= x[i % M];
        }
        z[q] += 1;
        for (p = i % 2; p < 9; p += 2)
            z[p + odd[i]] += x[p];
    }
}

int main(void) {
    static double *rows[N];
    for (int i = 0; i < N; i++) {
        cluster[i] = case_below(K);
        odd[i] = case_below(N - 10);
        start[i + 1] = start[i] + (case_below(3) == 0) * case_below(6);
        feature_row[i] = feature[i];
        rows[i] = x + i;
        for (int j = 0; j < W; j++)
            feature[i][j] = (float)case_value();
    }
    case_values(x, M);
    for (int k = 0; k < 4; k++) {
        k_means(N, k == 3 ? 0 : W - k, feature_row, centre, size_of);
        counter_used_after(N, k == 2 ? -5 : W, flat, feature[0]);
        segments(N - k);
        unsigned_sums(N);
        others(N);
        through_pointers(N, y, rows, 5);
        by_steps(N - k, y);
        cluster[k * 100] = case_below(K);
    }
    CASE_PRINT(centre);
    CASE_PRINT(size_of);
    CASE_PRINT(flat);
    CASE_PRINT(last_seen);
    CASE_PRINT(y);
    CASE_PRINT(z);
    CASE_PRINT(counts);
    return 0;
}
