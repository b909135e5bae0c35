/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Scalars and arrays private to an iteration, and their values after the loop.
// covers: row 58, row 59, row 5, row 6, row 7 of docs/constructs.md
#include "case.h"
#include <math.h>

enum { N = 12000, M = 700 };
static int s[N][2];
static double x[M], h[M];
static double kept[8];

static void scalars(int n) {
    int i = -1, j = -1;
    double d = -1.0, e;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        i = s[t][0];
        j = s[t][1];
        d = x[i] - x[j];
        e = d > 0.0 ? sqrt(d) : -d;
        h[i] += e;
        h[j] -= e;
    }
    kept[0] = i;
    kept[1] = j;
    kept[2] = d;
}

static void arrays(int n) {
    double f[3], g[2][2];
    int c;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double local[2] = {x[s[t][0]], x[s[t][1]]};
        for (c = 0; c < 3; c++)
            f[c] = local[0] * c - local[1];
        for (c = 0; c < 4; c++)
            g[c / 2][c % 2] = f[c % 3];
        h[s[t][0]] += f[0] + f[1] * f[2];
        h[s[t][1]] += g[0][0] - g[1][1];
    }
}

static void control(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = s[t][0];
        double sum = 0.0;
        int k = 0;
        if (i == s[t][1])
            continue;
        while (k < i % 7) {
            if (k == 5)
                break;
            sum += x[k];
            k++;
        }
        switch (i % 3) {
        case 0:
            sum *= 2.0;
            break;
        case 1:
            sum -= 1.0;
            /* fall through */
        default:
            sum += 0.5;
        }
        h[i] += sum;
    }
}

static void values_decide(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = s[t][0], j = s[t][1];
        const double d = x[i] - 0.25 * x[j];
        if (d < -0.75)
            continue;
        h[i] += d;
        if (d > 0.0)
            h[j] += x[i];
        else if (d < -0.5)
            h[j] -= x[i];
    }
}

/* A function fills a list of neighbours. The list's length follows from bounds with one unknown, `row` or `column`. */
static void row_and_column(int place, int *row, int *column) {
    *row = place / 20;
    *column = place % 20;
}

static int around(int place, int *list) {
    int row, column, count = 0;
    row_and_column(place, &row, &column);
    for (int i = row - 1; i <= row + 1; i++)
        for (int j = column - 1; j < column + 2; ++j)
            list[count++] = (i * 20 + j + M) % M;
    return count;
}

static void neighbours(int n) {
    int list[9];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int count = around(s[t][0], list);
        for (int q = 0; q < count; q++)
            h[list[q]] += 0.125 * q + x[s[t][1]];
    }
}

int main(void) {
    case_values(x, M);
    for (int round = 0; round < 3; round++) {
        case_subscripts(&s[0][0], 2 * N, M);
        scalars(N - round);
        if (getenv("CASE_INTEGERS") != NULL)
            for (int i = 0; i < M; i++)
                h[i] = 0.0; /* square roots are not exact on integers */
        arrays(N);
        control(N);
        values_decide(N);
        neighbours(N / 2);
        CASE_PRINT(kept);
        CASE_PRINT(h);
    }
    scalars(0);
    CASE_PRINT(kept);
    return 0;
}
