/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Subscripts from pure look-up functions. The table's contents change between calls at the same addresses, so
// a plan that is wrongly reused changes the result.
// covers: row 17, row 71 of docs/constructs.md
#include "case.h"

enum { N = 6000, ROWS = 300, WIDTH = 12 };

struct matrix {
    int *start, *column;
    double (*value)[2];
};
static int pair[N][2], permuted[N][1], start[ROWS + 1], column[ROWS * WIDTH];
static double weight[N], value[ROWS * WIDTH][2];

/* Reads from the row's start up to the element that it finds. */
static int walk(const struct matrix *A, int row, int wanted) {
    int k = A->start[row];
    while (A->column[k] < wanted)
        k++;
    return k;
}

/* Stops in the middle of a row: its result alone does not show how far it reads. */
static int scan(const struct matrix *A, int row, int wanted) {
    for (int k = A->start[row]; k < A->start[row + 1]; k++)
        if (A->column[k] >= wanted)
            return k;
    return A->start[row + 1] - 1;
}

static int bisect(const struct matrix *A, int row, int wanted) {
    int low = A->start[row], high = A->start[row + 1] - 1;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (A->column[middle] < wanted)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static double scaled(const int *through, const double *w, int t) {
    return 0.5 * w[through[0]] + t;
}

static void by_walk(int n, const int (*through)[1], const double *w, struct matrix *A) {
    int p;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p = walk(A, pair[t][0], pair[t][1]);
        const double s = scaled(through[t], w, t);
        const int q = walk(A, pair[t][0], pair[t][1] / 2);
        for (int c = 0; c < 2; c++)
            A->value[p][c] += s;
        A->value[q][0] -= s;
    }
}

static void by_scan(int n, struct matrix *A) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int p = scan(A, pair[t][0], pair[t][1]);
        A->value[p][0] += weight[t];
    }
}

static void by_bisection(int n, struct matrix *A) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int p = bisect(A, pair[t][0], pair[t][1]);
        A->value[p][1] -= weight[t];
    }
}

/* Fills rows with ascending columns; the last column exceeds all that are searched for. */
static void fill(int stride) {
    for (int r = 0; r < ROWS; r++) {
        start[r] = r * WIDTH;
        for (int k = 0; k < WIDTH; k++)
            column[r * WIDTH + k] = k + 1 < WIDTH ? k * stride + r % stride : 1000000;
    }
    start[ROWS] = ROWS * WIDTH;
}

int main(void) {
    struct matrix A = {start, column, value};
    case_values(weight, N);
    for (int t = 0; t < N; t++) {
        pair[t][0] = (int)((long)t * ROWS / N);
        pair[t][1] = case_below(60);
    }
    case_subscripts(&permuted[0][0], N, N);
    for (int round = 0; round < 4; round++) {
        fill(3 + round / 2); /* each table twice, then other columns at the same addresses */
        by_walk(N, (const int (*)[1])permuted, weight, &A);
        by_scan(N, &A);
        by_bisection(N, &A);
        CASE_PRINT(value);
    }
    return 0;
}
