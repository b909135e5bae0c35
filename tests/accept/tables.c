/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A function computes which element of a table it reads, and clamps the subscript. The table is
// disjoint from the updated memory, inside it, behind it in one block of memory, or does not exist.
// INTEGERS: no
#include <math.h>
#include <stdlib.h>
#include <unistd.h>

#include "case.h"

enum { N = 3000, ROWS = 500, ENTRIES = 40 };
struct table { int n; double x0, inverse, *values; };
struct pot { struct table *phi; double cut; };

static int k[N], l[N];
static double x[N], block[2 * ROWS + ENTRIES + 3], found[40 * ROWS];

/* Interpolates by a spline; reads from one entry below the first to two behind the last. */
static void interpolate(struct table *t, double r, double *f, double *df) {
    const double *v = t->values;
    if (r < t->x0)
        r = t->x0;
    r = (r - t->x0) * t->inverse;
    int i = (int)floor(r);
    if (i > t->n) {
        i = t->n;
        r = t->n / t->inverse;
    }
    r = r - floor(r);
    const double g = v[i + 1] - v[i - 1];
    *f = v[i] + 0.5 * r * (g + r * (v[i + 1] + v[i - 1] - 2.0 * v[i]));
    *df = g + r * (v[i + 2] - v[i] - g);
}

__attribute__((noipa)) static double pairs(struct pot *p, double *h, double *h2, int n) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double f, df;
        const double d = x[t];
        if (d > p->cut)
            continue;
        interpolate(p->phi, d, &f, &df);
        h[k[t]] += f;
        h[l[t]] -= f;
        h2[l[t]] += df;
        sum += df;
    }
    return sum;
}

/* Clamps an integer at both ends; `rounded` needs no lower bound, since a root is not negative; `either` calls both. */
static double clamped(const struct table *t, int i) {
    if (i >= t->n)
        i = t->n - 1;
    if (i < 0)
        i = 0;
    return t->values[i];
}
static double rounded(const struct table *t, double r) {
    int i = sqrt(r) * 0.5 + 1.5;
    if (i > t->n)
        i = t->n;
    return t->values[i - 1] + t->values[i];
}
static double either(const struct table *t, int i, double r) {
    return clamped(t, i - 1) + rounded(t, r);
}

__attribute__((noipa)) static void whole(const struct table *t, double *h, int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[k[i]] += clamped(t, k[i] - 50);
        h[l[i]] += either(t, l[i] / 2, x[i] * x[i] * 1e4);
    }
}

static void keep(int number) {
    for (int i = 0; i < ROWS; i++)
        found[number * ROWS + i] = block[i] + 3 * block[ROWS + i];
}

int main(void) {
    double sums[12] = {0};
    case_subscripts(k, N, ROWS);
    case_subscripts(l, N, ROWS);
    case_values(x, N);
    double *const values = malloc((ENTRIES + 3) * sizeof *values);
    case_values(values, ENTRIES + 3);
    struct table table = {ENTRIES - 1, -0.5, ENTRIES, values + 1};
    struct pot pot = {&table, 0.6};
    int number = 0;
    for (int round = 0; round < 4; round++) {
        table.values = values + 1;
        usleep(100);
        sums[number] = pairs(&pot, block, block + ROWS, N);
        keep(number++);
        usleep(100);
        whole(&table, block, N);
        keep(number++);
        if (round == 1) /* behind the rows, in the same object: disjoint as well */
            table.values = block + 2 * ROWS + 1;
        if (round == 2) /* the last entry is the first row: only some iterations read it */
            table.values = block + ROWS - ENTRIES - 1;
        if (round == 3) { /* the table is read backwards: the bounds derived from `inverse` do not hold */
            table.values = block + 2 * ROWS + ENTRIES - 2;
            table.inverse = -ENTRIES;
        }
        usleep(100);
        sums[number] = pairs(&pot, block, block + ROWS, N);
        keep(number++);
        table.inverse = ENTRIES;
        table.values = block + ROWS - ENTRIES; /* only its last entries overlap the updated rows, block + ROWS onwards */
        usleep(100);
        sums[0] += pairs(&pot, block + ROWS, block + ROWS, N);
    }
    pot.cut = -2; /* no iteration reads the table */
    pot.phi = NULL;
    usleep(100);
    sums[11] = pairs(&pot, block, block + ROWS, N);
    keep(12);
    pot = (struct pot){&table, 0.6};
    table.values = values + 1;
    usleep(100);
    sums[11] += pairs(&pot, block, block + ROWS, N);
    CASE_PRINT(block);
    CASE_PRINT(found);
    CASE_PRINT(sums);
    return 0;
}
