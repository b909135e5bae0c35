/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops as in binned_rows_of_arrays.c, but points or centres overlap the sums. A guard detects this before it matters.
// MAY-RUN-SERIALLY: reads overlap updates
#define _GNU_SOURCE
#include <sys/mman.h>
#include <unistd.h>

#include "case.h"

enum { N = 4000, D = 16, CENTRES = 24, ROWS = 300 };
static float points[N][D], centres[CENTRES][D];
static double w[N], flat[ROWS * D];
static int member[N], key[N];
static struct sums {
    float before[CENTRES][D], sums[CENTRES][D], behind[CENTRES][D];
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
}

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
}

/* Returns rows that begin `row` rows after the start of `*sums`. */
static float (*rows_from(int row))[D] {
    return (float(*)[D])((char *)sums + (size_t)row * sizeof *sums->sums);
}

int main(void) {
    /* `few`: only rows 0 to 4 of centres are mapped, and the loop ends there. */
    const long page = sysconf(_SC_PAGESIZE);
    char *memory = mmap(NULL, 2 * (size_t)page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    float(*few)[D] = (float(*)[D])(memory + page) - 5;
    if (memory == MAP_FAILED || munmap(memory + page, (size_t)page))
        return 1;
    few[4][2] = 1.0f;
    for (int t = 0; t < N; t++) {
        for (int j = 0; j < D; j++)
            points[t][j] = (float)case_value();
        w[t] = case_value();
        key[t] = case_below(ROWS);
    }
    for (int c = 0; c < CENTRES; c++)
        for (int j = 0; j < D; j++)
            centres[c][j] = sums->sums[c][j] = points[c * 7][j];
    for (int round = 0; round < 3; round++) {
        kmeans(CENTRES, sums->sums, centres, member, sums);
        kmeans(N, points, sums->sums, member, sums);
        /* First only the last row that the loop over centres reads is a sum, then several rows or none. */
        kmeans(N, points, rows_from(1), member, sums);
        kmeans(N, points, rows_from(0), member, sums);
        kmeans(N, points, rows_from(2 * CENTRES - 1), member, sums);
        kmeans(N, points, rows_from(2 * CENTRES), member, sums);
        kmeans_early(N, points, sums->sums, sums->sums, sums->counts);
        of_numbers(ROWS / 2, D, flat, key, flat + 7);
        CASE_PRINT(sums);
        CASE_PRINT(flat);
        CASE_PRINT(member);
        kmeans(N, points, centres, member, sums);
        CASE_PRINT(sums);
        kmeans_early(N, points, few, sums->sums, sums->counts);
        CASE_PRINT(sums);
    }
    return 0;
}
