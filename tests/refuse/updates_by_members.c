/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/updates_by_members.c: the functions write
// elsewhere, or to an element that is not known in advance.
// covers: row 87 of docs/constructs.md
enum { N = 4000 };

typedef struct matrix {
    int rows, columns;
    double *values;
    int *start;
} matrix;

extern int row[N], column[N];
extern double e[N];

static void add_some(matrix *m, int r, int k, double value) {
    if (k < m->columns)
        m->values[r * m->columns + k] += value * m->values[0];
}

void sometimes(matrix *m, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        add_some(m, row[t], column[t], e[t]);
}

static void add_by_table(matrix *m, int r, int k, double value) {
    m->values[m->start[r] + k] += value;
    m->start[k]++;
}

void by_table(matrix *m, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        add_by_table(m, row[t], column[t], e[t]);
}

static void add_both(matrix *m, int r, int k, double value) {
    m->values[r * m->columns + k] += value;
    m->values[k * m->columns + r] += m->values[r * m->columns + k];
}

void two_elements(matrix *m, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        add_both(m, row[t], column[t], e[t]);
}

static void add_and_move(matrix *m, int r, double value) {
    m->values[r] += value;
    m->values++;
}

void moves(matrix *m, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        add_and_move(m, row[t], e[t]);
}

static double add_and_tell(matrix *m, int r, int k, double value) {
    return m->values[r * m->columns + k] += value;
}

double tells(matrix *m, int n) {
    double last = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        last = add_and_tell(m, row[t], column[t], e[t]);
    return last;
}

static void mat_add(matrix *m, int r, int k, double value) {
    m->values[r * m->columns + k] += value;
}

void reads_too(matrix *m, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        mat_add(m, row[t], column[t], m->values[t]);
}

void columns_change(matrix *m, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-array-written
        mat_add(m, row[t], column[t], e[t]);
        m->columns = 1 + t % 2;
    }
}

void values_change(matrix *m, double *other, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse other-store
        mat_add(m, row[t], column[t], e[t]);
        m->values = other + t;
    }
}

union either {
    matrix m;
    double own[8];
};

static void add_in_union(union either *u, int r, double value) {
    u->own[r & 7] += value;
    u->m.columns = r;
}

void in_a_union(union either *u, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        add_in_union(u, row[t], e[t]);
}

void object_changes(matrix *m, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse base-varies
        mat_add(m, row[t], column[t], e[t]);
        m++;
    }
}
