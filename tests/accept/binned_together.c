// Several arrays are updated at one subscript. One record serves all of them if each is updated only together
// with the others. Sums, counts, minima, functions of the element, arrays of several types, different
// subscripts of equal text, and more arrays or operands than a record can hold.
// INTEGERS: no
// CFLAGS: -Wno-implicit-fallthrough
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "case.h"

enum { N = 3000, M = 200 };
static int i1[N], i2[N];
static double w[N], u[N], fx[M + 2], fy[M + 2], fz[M + 2], low[M], high[M];
static double p0[M], p1[M], p2[M + M / 4], p3[M], p4[M], p5[M];
static float part[N], sums[M];
static long counts[M], totals[M];
static unsigned char small[M];
static double rows[M][3], other_rows[M][3], wide_rows[M][2];
static struct cell {
    double mass;
    double charge;
} cells[M], other_cells[M];

static void springs(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = i1[t], j = i2[t];
        const double a = w[t] * u[t], b = w[t] + u[t], c = w[t] - u[t];
        fx[i] += a;
        fy[i] += b;
        fz[i] += c;
        fx[j] -= a;
        fy[j] -= b;
        fz[j] -= c;
    }
} // BINNED: 27

static void interleaved(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fx[i1[t]] += w[t];
        fx[i2[t]] *= 0.5;
        fy[i1[t]] += u[t];
        fy[i2[t]] *= 0.75;
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fx[i1[t]] += w[t];
        fx[i2[t]] *= 0.5;
        fy[i2[t]] += u[t];
        fy[i1[t]] *= 0.75;
    }
} // BINNED: 40 46

static void means(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        counts[i1[t]]++;
        sums[i1[t]] += part[t];
        fx[i1[t]] += part[t];
    }
} // BINNED: 55

static void extrema(int n, const int *restrict k, const double *restrict x, double *restrict least,
                    double *restrict most) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (x[t] < least[k[t]])
            least[k[t]] = x[t];
        if (x[t] > most[k[t]])
            most[k[t]] = x[t];
    }
} // BINNED: 64

static void only_integers(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        counts[i1[t]] += t;
        small[i1[t]] ^= t;
        totals[i1[t]] -= i2[t];
    }
} // BINNED: 73

static void not_always_together(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fx[i1[t]] += w[t];
        fy[i1[t]] += u[t];
        fz[i1[t]] += w[t];
        fx[i2[t]] = fx[i2[t]] * 0.5 + w[t];
        fy[i2[t]] = fy[i2[t]] * 0.5 + u[t];
    }
} // BINNED: 81

static void under_a_condition(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (i2[t] % 3) {
            fx[i1[t]] += w[t];
            fy[i1[t]] += u[t];
        } else {
            fx[i2[t]] -= w[t];
            fy[i2[t]] -= u[t];
        }
    }
} // BINNED: 91

static void some_under_a_condition(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fx[i1[t]] += w[t];
        if (i2[t] % 3) {
            fy[i1[t]] += u[t];
        }
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (i2[t] % 3) {
            fx[i1[t]] += w[t];
        }
        fy[i1[t]] += u[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (i2[t] % 3)
            fx[i1[t]] += w[t];
        else
            fy[i1[t]] += u[t];
    }
} // BINNED: 103 109 115

static void apart_by_a_statement(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = i1[t];
        fx[i] += w[t];
        i = i2[t];
        fy[i] += u[t];
    }
} // BINNED: 124

static void only_alike(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fx[i1[t]] += w[t];
        fy[i1[t] + 1] += u[t];
        fz[i2[t]] += w[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        cells[i1[t]].mass += w[t];
        other_cells[i1[t]].charge += u[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        rows[i1[t]][1] += w[t];
        wide_rows[i1[t]][1] += u[t];
    }
} // BINNED: 133 138 142

static void in_rows(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            rows[i1[t]][c] += w[t] * c;
            other_rows[i1[t]][c] -= u[t];
        }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        cells[i1[t]].charge += w[t];
        other_cells[i1[t]].charge += u[t];
    }
} // BINNED: 149 154

static void twice(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fx[i1[t]] += w[t];
        fx[i1[t]] *= 0.5;
        fy[i1[t]] += u[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fx[i1[t]] += w[t];
        fy[i1[t]] += u[t];
        fx[i1[t]] *= 0.5;
        fy[i1[t]] *= 0.25;
    }
} // BINNED: 161 166

static void many_arrays(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p0[i1[t]] += w[t];
        p1[i1[t]] += u[t];
        p2[i1[t]] += w[t] * u[t];
        p3[i1[t]] += w[t] + u[t];
        p4[i1[t]] += w[t] - u[t];
        p5[i1[t]] += w[t] * 2;
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p0[i2[t]] += w[t];
        p1[i2[t]] -= w[t];
        p2[i2[t]] += w[t];
        p3[i2[t]] -= w[t];
        p4[i2[t]] += w[t];
        p5[i2[t]] -= w[t];
    }
} // BINNED: 175 183

static void many_operands(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p0[i1[t]] = p0[i1[t]] * w[t] + u[t];
        p1[i1[t]] = p1[i1[t]] * (w[t] - 1) + (u[t] - 1);
        p2[i1[t]] = p2[i1[t]] * (w[t] - 2) + (u[t] - 2);
    }
} // BINNED: 194

static void operands_of_two_types(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fx[i1[t]] += 1;
        fy[i1[t]] += w[t];
        fz[i1[t]] += part[t];
        fx[i2[t]] += 1;
        fy[i2[t]] *= 2;
        fz[i2[t]] -= part[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fx[i1[t]] += w[t];
        sums[i1[t]] += part[t];
        fx[i2[t]] += w[t];
        sums[i2[t]] += w[t];
    }
} // BINNED: 202 210

static void operands_that_fit_nowhere(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        fx[i1[t]] += w[t];
        sums[i1[t]] += part[t];
        fx[i2[t]] += part[t];
        sums[i2[t]] += w[t];
    }
} // NOT-BINNED: 219

#define ADD(at, a, b)                                                                              \
    do {                                                                                           \
        x[at] += a;                                                                                \
        y[at] += b;                                                                                \
    } while (0)
static void by_macro(int n, double *restrict x, double *restrict y) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        ADD(i1[t], w[t], u[t] * 2);
        ADD(i2[t], -w[t], -u[t]);
    }
} // BINNED: 233

static void by_case(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        switch (i2[t] % 3) {
        case 0:
            fx[i1[t]] += w[t];
            fy[i1[t]] += u[t];
            break;
        case 1:
            fx[i1[t]] -= w[t];
        case 2:
            fy[i1[t]] -= u[t];
        }
} // BINNED: 240

static void that_overlap(int n, double *a, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        a[i1[t]] += w[t];
        b[i1[t]] = b[i1[t]] * 0.5 + u[t];
    }
} // BINNED: 254

static void show_all(void) {
#define SHOW(array) case_print(#array, array, sizeof array)
    SHOW(fx), SHOW(fy), SHOW(fz), SHOW(low), SHOW(high), SHOW(sums), SHOW(counts), SHOW(totals);
    SHOW(small), SHOW(rows), SHOW(other_rows), SHOW(wide_rows), SHOW(cells), SHOW(other_cells);
    SHOW(p0), SHOW(p1), SHOW(p2), SHOW(p3), SHOW(p4), SHOW(p5);
}

// A NaN with the bits that the processor gives its own NaNs: results do not depend on where it arose.
static void odd_numbers(void) {
    volatile double infinite = INFINITY;
    w[11] = infinite - infinite, w[12] = -INFINITY, w[13] = INFINITY, w[14] = -0.0, w[15] = 1.7e308;
    u[11] = -0.0, u[12] = INFINITY, u[13] = w[11], u[14] = 5e-324, u[15] = -1.7e308;
    for (int t = 11; t < 16; t++)
        i1[t] = t / 2, i2[t] = t / 3;
}

int main(void) {
    case_subscripts(i1, N, M);
    case_subscripts(i2, N, M);
    case_values(u, N);
    for (int t = 0; t < N; t++) {
        w[t] = case_value() * 3;
        part[t] = (float)case_value();
    }
    for (int i = 0; i < M; i++)
        fx[i] = fy[i] = -0.0, low[i] = 1, high[i] = -1;
    for (int round = 0; round < 2; round++) {
        springs(N);
        interleaved(N);
        means(N);
        extrema(N, i1, w, low, high);
        only_integers(N);
        not_always_together(N);
        under_a_condition(N);
        some_under_a_condition(N);
        apart_by_a_statement(N);
        only_alike(N);
        in_rows(N);
        twice(N);
        many_arrays(N);
        many_operands(N);
        operands_of_two_types(N);
        operands_that_fit_nowhere(N);
        by_macro(N, fx, fy);
        by_case(N);
        that_overlap(N, p0, p0);
        that_overlap(N / 2, p2, p2 + M / 4);
        that_overlap(N, p0, p1);
        show_all();
        memset(p0, 0, sizeof p0);
        memset(p2, 0, sizeof p2);
    }
    memset(fx, 0, sizeof fx);
    odd_numbers();
    springs(N);
    means(N);
    extrema(N, i1, w, low, high);
    show_all();
}
