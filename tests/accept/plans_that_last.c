/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Conditions that the inspector leaves out, since the elements that may be touched do not depend on
// them, and conditions that it must not leave out (tests/analysis/cases/plans_that_last.c).
// covers: row 78 of docs/constructs.md
#include "case.h"

enum { N = 3000, ROWS = 600 };
static int p[N], q[N], start[ROWS + 1];
static double x[3 * N + 3], f[3 * N + 8];

static void cut_off(int n, double *f, const double *x, const int *p,
             const int *q, double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = p[t], j = q[t];
        double d = x[i] - x[j];
        if (d * d > cut)
            continue;
        f[i] += d;
        f[j] -= d;
    }
}

static void cut_off_in_a_row(int n, double *f, const double *x,
                      const int *start, const int *q, double cut) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int k = start[i]; k < start[i + 1]; k++) {
            int j = q[k];
            double d = x[i] - x[j];
            if (d * d > cut)
                continue;
            f[i] += d;
            f[j] -= d;
        }
}

static void components(int n, double *f, const double *x, const int *p,
                double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = p[t];
        double r = x[3 * i] * x[3 * i + 1];
        if (r > cut)
            continue;
        for (int c = 0; c < 3; c++)
            f[3 * i + c] += r;
    }
}

static void components_under_a_condition(int n, double *f, const double *x,
                                  const int *p, double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = p[t];
        double r = x[3 * i] * x[3 * i + 1];
        if (r <= cut) {
            int first = 3 * i;
            for (int c = 0; c < 3; c++)
                f[first + c] += r;
        }
    }
}

/* The load of q[i] is executed only under the condition, and might be out of bounds otherwise. */
static void read_behind(int n, double *f, const double *x, const int *p,
                 const int *q, double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = p[t];
        if (x[i] <= cut) {
            int j = q[i];
            f[j] += x[i];
        }
    }
}

static void read_behind_in_a_row(int n, double *f, const double *x,
                          const int *start, const int *q, double cut) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int k = start[i]; k < start[i + 1]; k++) {
            if (x[k] > cut)
                continue;
            int j = q[k];
            f[j] += x[k];
        }
}

/* The condition's counter `place` keeps its value for the next turn of the inner loop. */
static void counted_in_a_row(int n, double *f, const double *x,
                      const int *start, double cut) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        int place = 0;
        for (int k = start[i]; k < start[i + 1]; k++) {
            if (x[k] > cut)
                continue;
            f[3 * start[i] + place] += x[k];
            place++;
        }
    }
}

static void kept_from_the_round_before(int n, double *f, const double *x,
                                const int *p, double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int at = p[t], c;
        for (c = 0; c < 3; c++) {
            if (x[3 * t + c] > cut)
                continue;
            f[at] += x[3 * t + c];
            at = c;
        }
    }
}

static void leaves_after(int n, double *f, const double *x, const int *start,
                  const int *q, double cut) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int k = start[i]; k < start[i + 1]; k++) {
            int j = q[k];
            if (x[k] > cut)
                continue;
            f[j] += x[k];
            if (j == 5)
                break;
        }
}

static void set_by_the_condition(int n, double *f, const double *x,
                          const int *p, double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = 0;
        if (x[t] > cut) {
            int j = p[t];
            i = j;
        }
        f[i] += x[t];
    }
}

/* The inner counter's value is used after the condition. */
static void counter_outlives(int n, double *f, const double *x, const int *p,
                      double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int c = 0;
        if (x[t] <= cut)
            for (c = 0; c < 3; c++)
                f[3 * p[t] + c] += x[t];
        f[p[t] + c] += 1;
    }
}

static void divides(int n, double *f, const double *x, const int *p, int m,
             double cut) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = p[t];
        if (x[t] <= cut) {
            int at = i / m;
            f[at] += x[t];
        }
    }
}

int main(void) {
    for (int k = 0; k <= ROWS; k++)
        start[k] = k * (N / ROWS - 1);
    case_subscripts(p, N, ROWS);
    case_near_subscripts(q, N, ROWS);
    for (int round = 0; round < 6; round++) {
        const double cut = 0.25 * round - 0.5;
        const int m = 3 + round;
        if (round < 2 || round == 4)
            case_values(x, 3 * N + 3);
        if (round == 3)
            case_subscripts(q, N, ROWS);
        cut_off(N, f, x, p, q, cut);
        cut_off_in_a_row(ROWS, f, x, start, q, cut);
        components(N, f, x, p, cut);
        components_under_a_condition(N, f, x, p, cut);
        read_behind(N, f, x, p, q, cut);
        read_behind_in_a_row(ROWS, f, x, start, q, cut);
        counted_in_a_row(ROWS, f, x, start, cut);
        kept_from_the_round_before(N, f, x, p, cut);
        leaves_after(ROWS, f, x, start, q, cut);
        set_by_the_condition(N, f, x, p, cut);
        counter_outlives(N, f, x, p, cut);
        divides(N, f, x, p, m, cut);
    }
    CASE_PRINT(f);
    return 0;
}
