/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A function returns the element's address. It computes the address from parameters, members, rows, variables of the
// file or other such functions. The loops use it in updates, other statements and operands.
// covers: row 92 of docs/constructs.md
#include "case.h"
#include <stddef.h>
#include <stdlib.h>

enum { N = 12000, M = 900, WIDTH = 30 };
static int edge[N][2], count[M];
static double w[N], h[M], m[M / WIDTH][WIDTH], x[M][3];
static float *field;
static int *tally;
static float fields[2][M];
static int shift;
struct cell {
    double low, high;
    int visits;
};
static struct cell grid[M];
struct table {
    double *value;
    int size;
    double own[M];
};

static double *slot(struct table *t, int k) {
    return t->value + k;
}

static inline double *own_slot(struct table *t, unsigned char k) {
    return &t->own[k];
}

static double *at(double *a, int ld, int i, int j) {
    return &a[i * ld + j];
}

static struct cell *cell_at(size_t k) {
    return &grid[k];
}

static double *highest_of(size_t k) {
    return &cell_at(k)->high;
}

static double *row(double (*rows)[3], long i) {
    return rows[i];
}

static float *in_field(int k) {
    return field + k;
}

static float *in_shifted_field(int k) {
    return &field[k + shift];
}

static int *count_of(int k) {
    return count + k;
}

struct flexible {
    int size;
    double value[];
};

static double *in_flexible(struct flexible *f, int k) {
    return &f->value[k];
}

static int *in_tally(int k) {
    return &tally[k];
}

enum { BEHIND = 5 };
static double *behind(double *a, int k) {
    return a + k + BEHIND;
}

static const double *weight(int k) {
    return &w[k];
}

static double *node_of(int e, int which) {
    return &h[edge[e][which]];
}

static void by_parameters(struct table *t, int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        *slot(t, edge[i][0]) += w[i];
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        *slot(t, edge[i][0]) -= *weight(i);
        *slot(t, edge[i][1]) += *weight(i) * 0.5;
    }
    for (int i = 0; i < n; i++) // EXPECT: transformed
        *own_slot(t, edge[i][0]) += w[i];
    for (int i = 0; i < n; i++) // EXPECT: transformed
        *at(&m[0][0], WIDTH, edge[i][0] % (M / WIDTH), edge[i][1] % WIDTH) += w[i];
}

static void at_the_end(struct flexible *f, int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        *in_flexible(f, edge[i][1]) += w[i];
}

static void with_other_names(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        enum { BEHIND = 2 };
        *behind(h, edge[i][0]) += BEHIND * w[i];
    }
}

static void of_records(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        cell_at(edge[i][0])->low -= w[i];
        cell_at((size_t)edge[i][1])->visits++;
    }
    for (int i = 0; i < n; i++) // EXPECT: transformed
        if (w[i] > 0.25)
            *highest_of(edge[i][1]) += w[i];
}

static void of_rows(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        row(x, edge[i][0])[0] += w[i];
        for (int c = 1; c < 3; c++)
            row(x, edge[i][1])[c] -= w[i] * c;
    }
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double *p = row(x, edge[i][0]);
        p[0] += w[i];
        p[2] -= w[i];
    }
}

/* The accessor names the global `field`, which must stay the global while the loop writes private copies of it. */
static void of_the_file(int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        *in_field(edge[i][0]) += (float)w[i];
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        field[edge[i][0]] += 1;
        *in_field(edge[i][1]) -= (float)w[i];
    }
    for (int i = 0; i < n; i++) // EXPECT: transformed
        (*count_of(edge[i][0]))++;
    for (int i = 0; i < n; i++) // EXPECT: transformed
        *in_tally(edge[i][1] % 16) += i;
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        ++*count_of(edge[i][0]);
        count[edge[i][1]] += 3;
    }
    for (int i = 0; i < n; i++) // EXPECT: transformed
        *node_of(i, 0) += w[i];
    for (int i = 0; i < n; i++) // EXPECT: transformed
        *in_shifted_field(edge[i][0]) += 2;
}

/* The accessor reads the global `field`, even where the generated loop names `h` by another identifier. */
static void in_operands(struct table *t, int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        h[edge[i][0]] += *in_field(i % M) * *weight(i);
    for (int i = 0; i < n; i++) { // EXPECT: refuse text
        double v = *slot(t, edge[i][0]);
        v += *in_field(i % M);
        *slot(t, edge[i][0]) = v;
    }
}

int main(void) {
    static struct table t;
    static double values[M], sums[2];
    struct flexible *f = calloc(1, sizeof *f + M * sizeof *f->value);
    t.value = values;
    case_values(w, N);
    for (int round = 0; round < 6; round++) {
        if (round % 2 == 0) {
            case_subscripts(&edge[0][0], N, M - 20);
            case_subscripts(&edge[0][0] + N, N, M - 20);
        }
        const int n = round == 3 ? 5000 : N;
        field = fields[round % 2];
        tally = count + round;
        shift = round * 3;
        by_parameters(&t, n);
        at_the_end(f, n);
        with_other_names(n);
        of_records(n);
        of_rows(n);
        of_the_file(n);
        in_operands(&t, n);
        CASE_PRINT(values);
        sums[1] += f->value[round] + f->value[7 * round];
        CASE_PRINT(t.own);
        CASE_PRINT(m);
        CASE_PRINT(x);
        CASE_PRINT(h);
        CASE_PRINT(fields);
        CASE_PRINT(count);
        for (int i = 0; i < M; i++)
            sums[0] += grid[i].low + grid[i].high + grid[i].visits;
        CASE_PRINT(sums);
    }
    free(f);
    return 0;
}
