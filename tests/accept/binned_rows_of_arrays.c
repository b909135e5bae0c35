/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Rows of arrays in bins: an inner loop over a row becomes one record, whose operands are read when it is applied. Rows
// of matrices, of flat arrays and of members, overlapping rows, and rows in front of the address that a pointer holds.
// The last functions get no such records, because the inner loop's header sets an operand, the row or the bound.
#include <math.h>

#include "case.h"

enum { N = 4000, D = 16, CENTRES = 24, ROWS = 300 };
static float points[N][D], centres[CENTRES][D];
static double w[N], flat[ROWS * D], other[ROWS][D + 3], apart[CENTRES][D], all[2 * ROWS + D], *rows[CENTRES];
static int member[N], key[N], length[N];
static struct sums {
    float sums[CENTRES][D];
    int counts[CENTRES], changes;
} sums[1];

/* One sum in memory, own elements (`to[p]`), and counters in addition to the row. */
static void kmeans(int n, const float (*x)[D], const float (*centre)[D], int *to, struct sums *its) {
    for (int p = 0; p < n; p++) { // EXPECT: transformed
        float least = 1e30f;
        int nearest = 0;
        for (int c = 0; c < CENTRES; c++) {
            float d = 0;
            for (int k = 0; k < D; k++)
                d += (x[p][k] - centre[c][k]) * (x[p][k] - centre[c][k]);
            if (d < least) {
                least = d;
                nearest = c;
            }
        }
        if (to[p] != nearest)
            its->changes++;
        to[p] = nearest;
        its->counts[nearest]++;
        for (int k = 0; k < D; k++)
            its->sums[nearest][k] += x[p][k];
    }
} // BINNED: 20

/* Not all points read the last centres: a loop that may end early reads only as far as it runs. */
static void kmeans_early(int n, const float (*x)[D], const float (*centre)[D], float (*to)[D], int *counts) {
    for (int p = 0; p < n; p++) { // EXPECT: transformed
        int nearest = 0;
        for (int c = 1; c <= CENTRES - 2; c++) {
            if (x[p][0] < centre[c][1])
                nearest = c;
            if (centre[c + 1][2] > 0.99f)
                break;
        }
        counts[nearest]++;
        for (int k = 0; k < D; k++)
            to[nearest][k] += x[p][k];
    }
}

static void of_numbers(int n, int d, double *to, const int *at, const double *by) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int j = 0; j < d; j++)
            to[at[t] * d + j] += by[t] * (j + 1);
} // BINNED: 58

/* Each element belongs to several rows, and its next value depends on the previous one. */
static void overlapping(int n, int d) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int j = 0; j < d; j++)
            all[2 * key[t] + j] = w[t] - all[2 * key[t] + j] * 0.5;
} // BINNED: 65

/* Lengths that differ from iteration to iteration, a first subscript other than 0, and rows of variable length. */
static void lengths(int n, double (*to)[D + 3]) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double scale = w[t] * 0.25;
        if (key[t] % 5 != 3)
            for (int j = 2; j <= length[t]; j++)
                to[key[t]][j] -= scale * (double)j + (double)points[t][1];
    }
}

/* Rows at negative offsets from the pointer, which points into an array. */
static void middle(int n, int d, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int j = 0; j < d; j++)
            to[(key[t] - ROWS / 2) * 8 + j] -= 2 * w[t];
} // BINNED: 82

/* The inner header sets more than its counter: an operand, the row, or the bound. */
static void sets_operand(int n, int d) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int j;
        double by = t * 0.5;
        for (j = 0, by = w[t]; j < d; j++)
            flat[key[t] * D + j] += by * points[t][j];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int j;
        double by = t * 0.5;
        for (j = 0, by = w[t]; j < d; j++)
            rows[key[t] % CENTRES][j] += by * points[t][j];
    }
}
static void sets_row(int n, int d) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int j, at = 0;
        for (j = 0, at = key[t]; j < d; j++)
            flat[at * D + j] += w[t];
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int j = 0, at = key[t] % CENTRES; j < d; j++)
            rows[at][j] += w[t] * at;
}
static void sets_bound(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int j, end = 0;
        for (j = 0, end = length[t] - 2; j < end; j++)
            flat[key[t] * D + j] += w[t];
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int j = 0, end = length[t]; j < end - 2; j++)
            rows[key[t] % CENTRES][j] += w[t] * end;
}
static void steps_with(int n, int d, const double *by) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int j, k = 3;
        for (j = 0, k = t % 7; j < d; j++, k++)
            flat[key[t] * D + j] += by[k];
    }
}

int main(void) {
    for (int t = 0; t < N; t++) {
        for (int j = 0; j < D; j++)
            points[t][j] = (float)case_value();
        w[t] = case_value();
        key[t] = case_below(ROWS);
        length[t] = case_below(D);
    }
    points[77][3] = NAN;
    for (int c = 0; c < CENTRES; c++) {
        rows[c] = apart[c * 7 % CENTRES];
        for (int j = 0; j < D; j++)
            centres[c][j] = points[c * 7][j];
    }
    for (int round = 0; round < 4; round++) {
        kmeans(N - round, points, centres, member, sums);
        CASE_PRINT(sums);
        kmeans_early(N, points, centres, sums->sums, sums->counts);
        of_numbers(N, D - round, flat, key, w);
        overlapping(N, D);
        lengths(N, other);
        middle(N, D - round * 5, &flat[ROWS / 2 * 8]);
        sets_operand(N, D);
        sets_row(N, D);
        sets_bound(N);
        steps_with(N, D, w);
        CASE_PRINT(sums);
        CASE_PRINT(member);
        CASE_PRINT(flat);
        CASE_PRINT(all);
        CASE_PRINT(other);
        CASE_PRINT(apart);
        centres[round][3] = 0.25f;
        w[round * 5] *= 2;
    }
    return 0;
}
