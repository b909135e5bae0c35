/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -Wno-sign-compare
// INTEGERS: no
// Tables declared outside the loop: an inner loop fills them, and inner loops with the same header read them.
#include "case.h"

enum { N = 1500, SIDE = 24, TABLE = 12 };
static int s[N], c[N], lows[N], highs[N];
static double e[N], x[N], y[N], h[SIDE * 4], grid[SIDE * SIDE], line[SIDE];

/* A window clipped to the grid, of a width known at run time; the tables' subscript is x - low. */
static void clipped(int n, double radius) {
    double across[TABLE], down[TABLE];
    int i, j;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int left = (int)(x[t] - radius), right = (int)(x[t] + radius);
        int top = (int)(y[t] - radius), bottom = (int)(y[t] + radius);
        left = left < 0 ? 0 : left;
        right = right < SIDE ? right : SIDE - 1;
        top = top < 0 ? 0 : top;
        bottom = bottom < SIDE ? bottom : SIDE - 1;
        for (i = left; i <= right; i++)
            across[i - left] = (x[t] - i) * (x[t] - i);
        for (j = top; j <= bottom; j++)
            down[j - top] = (y[t] - j) * (y[t] - j);
        for (j = top; j <= bottom; j++)
            for (i = left; i <= right; i++)
                if (across[i - left] + down[j - top] < radius * radius)
                    grid[j * SIDE + i] += e[t] * (across[i - left] + down[j - top]);
    }
}

/* Two counters, and unsigned bounds compared with an int. */
static void two_counters(int n) {
    double w[TABLE];
    int at, k;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        unsigned low = (unsigned)lows[t], high = (unsigned)highs[t];
        for (k = 0, at = low; at <= high; ++at, ++k)
            w[k] = e[t] * at;
        for (k = 0, at = low; at <= high; ++at, ++k)
            line[at] += w[k];
    }
}

/* Splines whose order is a parameter; each loop has its own counter. */
static void splines(int n, int order) {
    double a[TABLE], b[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int k = 0; k < order; k++) {
            a[k] = x[t] / (k + 1);
            b[k] = y[t] - k;
        }
        for (int i = 0; i < order; i++)
            for (int j = 0; j < order; j++)
                grid[(s[t] + i) % SIDE * SIDE + j] += a[i] * b[j];
    }
}

/* The table gives the subscripts; loops run downwards in steps of two. */
static void subscripts(int n) {
    int place[SIDE];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int high = highs[t];
        for (int k = high; k >= 0; k -= 2)
            place[k] = (s[t] + k * 3) % (SIDE * 4);
        for (int k = high; k >= 0; k -= 2)
            h[place[k]] += e[t];
    }
}

/* Under a condition, the table is written, changed and read twice. The loop that reads it may end early. */
static void changed_again(int n, int order) {
    double w[TABLE];
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (c[t]) {
            const double scale = x[t];
            for (k = 0; k < order; k++) {
                const double v = scale * k;
                w[k] = v;
            }
            for (k = 0; k < order; k++)
                w[k] += 0.5;
            for (int round = 0; round < c[t]; round++)
                for (k = 0; k < order; k++) {
                    if (w[k] > 9)
                        break;
                    h[(s[t] + k) % SIDE] += w[k];
                }
        }
    }
}

int main(void) {
    case_subscripts(s, N, SIDE * 4);
    case_subscripts(c, N, 3);
    case_values(e, N);
    for (int t = 0; t < N; t++) {
        lows[t] = case_below(SIDE / 2);
        highs[t] = lows[t] + case_below(TABLE);
        x[t] = case_below(SIDE) + (case_value() > 0 ? 0.25 : 0.5);
        y[t] = case_below(SIDE) + (case_value() > 0 ? 0.75 : 0.5);
    }
    for (int round = 0; round < 3; round++) {
        clipped(N, 2.5 + round);
        two_counters(N);
        splines(N, 3 + round);
        subscripts(N);
        changed_again(N, 4 + round);
    }
    CASE_PRINT(grid);
    CASE_PRINT(line);
    CASE_PRINT(h);
    return 0;
}
