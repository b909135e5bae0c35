/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Updates in several statements: an element is loaded, changed and stored again.
// covers: row 82 of docs/constructs.md
#include <math.h>
#include "case.h"

enum { N = 4000, ROWS = 90 };
struct cell {
    double mass, high;
    int count;
};
static int k[N], second[N];
static double w[N], h[ROWS + 4], g[ROWS];
static float narrow[ROWS];
static struct cell cells[ROWS];
static unsigned char small[ROWS];
static double table[ROWS][3];

static void plain(int n, const double *w, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double v = h[k[t]];
        v += w[t];
        h[k[t]] = v;
    }
}

static double with_conditions(int n, double *h, const double *limit) {
    int i;
    double v, last = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        i = k[t];
        v = h[i];
        v = 0.75 * v + w[t];
        if (v > *limit)
            v = *limit;
        else if (v < 0) {
            const double twice = 2 * v;
            v = twice < -9 ? 0.5 : twice;
        }
        h[i] = v + 1;
        if (t % 5 == 1) /* another update of the same element */
            h[i] -= 0.25;
        last = w[t];
    }
    return last;
}

static void members(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (w[t] != 0.125) {
            const struct cell *const from = cells; (void)from;
            int count = cells[k[t]].count; /* declared
                                              over lines */ count++; cells[k[t]].count = count;
            double high = cells[second[t]].high;
            for (int c = 0; c < 3; c++)
                high = fmax(high, w[(t + c) % N]);
            cells[second[t]].high = high;
        }
}

static void narrow_ones(int n) {
    for (int t = n - 1; t >= 0; t--) { // EXPECT: transformed
        double v = narrow[k[t]];
        v += w[t];
        narrow[k[t]] = (float)v;
        int c = small[second[t]];
        c = 3 * c + t;
        small[second[t]] = (unsigned char)c;
    }
}

static void rows(int n, double (*table)[3]) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            double old = table[k[t]][c];
            table[k[t]][c] = old * 0.5 + w[t];
        }
}

static void several_arrays(int n, double *a, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double x = a[k[t]];
        x -= w[t];
        a[k[t]] = x;
        double y = b[second[t]];
        b[second[t]] = y * 0.5 + w[t];
        a[second[t]] += 1;
    }
}

int main(void) {
    double limit = 3, sum = 0;
    for (int round = 0; round < 4; round++) {
        case_values(w, N);
        case_subscripts(k, N, ROWS);
        case_near_subscripts(second, N, ROWS);
        plain(50, h + 3, h); /* reads overlap updates */
        plain(N, w, h);
        sum = 0.5 * sum + with_conditions(N, h, &limit);
        members(N - round);
        narrow_ones(N);
        rows(N, table);
        several_arrays(N, g, h);
    }
    printf("%a\n", sum);
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(cells);
    CASE_PRINT(narrow);
    CASE_PRINT(small);
    CASE_PRINT(table);
    return 0;
}
