/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions get a matrix, row and column, and find the element through the matrix's members. These members
// differ from one execution to the next.
// covers: row 87 of docs/constructs.md
// MAY-RUN-SERIALLY: one call reads an element that it updates
#include "case.h"

enum { N = 4000, ROWS = 60, COLUMNS = 12 };

typedef struct matrix {
    int rows, columns;
    double *values;
    long counted[ROWS];
} matrix;

typedef struct solver {
    matrix *stiffness;
    matrix mass;
} solver;

static int row[N], column[N];
static double e[N], a[ROWS * COLUMNS], b[ROWS * COLUMNS], c[ROWS * COLUMNS];
static matrix whole = {ROWS, COLUMNS, c, {0}};

static void mat_add(matrix *m, int r, int k, double value) {
    m->values[r * m->columns + k] += value;
}

static void mat_add_backwards(matrix *m, long r, int k, double value) {
    m->values[(m->rows - 1 - r) * m->columns + k] -= 2.0 * value;
}

static void mat_count(matrix *m, int r) {
    m->counted[r]++;
}

static void stiffness_add(solver *s, int r, int k, double value) {
    s->stiffness->values[r * s->stiffness->columns + k] += value;
}

static void mass_add(solver *s, int r, int k, double value) {
    s->mass.values[r * s->mass.columns + k] += value;
}

static void assemble(matrix *m, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        mat_add(m, row[t], column[t], e[t]);
}

static void assemble_more(matrix *m, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        mat_add(m, row[t], column[t], e[t]);
        mat_add_backwards(m, row[t], column[t] / 2, e[t]);
        mat_count(m, row[t]);
        m->values[column[t]] += 1.0;
    }
}

static void assemble_both(solver *s, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int k = 0; k < 2; k++)
            stiffness_add(s, row[t], column[t] / 2 + k, e[t]);
        mass_add(s, row[t], column[t], 1.0);
    }
}

static void of_a_table(matrix **each, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        mat_add(each[column[t] & 1], row[t], column[t], e[t]);
}

static void beside_a_read(matrix *m, const double *from, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        mat_add(m, row[t], column[t], e[t] + from[t % COLUMNS]);
}

int main(void) {
    matrix own = {ROWS, COLUMNS, a, {0}};
    solver s = {&own, {ROWS, COLUMNS, b, {0}}};
    matrix *each[2] = {&own, &s.mass};
    case_values(e, N);
    for (int round = 0; round < 5; round++) {
        if (round != 3) {
            case_subscripts(row, N, ROWS);
            case_subscripts(column, N, COLUMNS / 2);
        }
        own.columns = whole.columns = round % 2 ? COLUMNS / 2 : COLUMNS;
        assemble(&own, N);
        assemble_more(&whole, N);
        own.columns = 7;
        assemble_both(&s, N);
        of_a_table(each, N);
        beside_a_read(&own, c, N - round);
        beside_a_read(&whole, c, N / 4); /* reads overlap updates: sequential */
    }
    CASE_PRINT(a);
    CASE_PRINT(b);
    CASE_PRINT(c);
    CASE_PRINT(whole.counted);
    return 0;
}
