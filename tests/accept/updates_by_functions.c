/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A function makes the update: it gets the address of the element or of the row.
// covers: row 18, row 20, row 37, row 87 of docs/constructs.md
#include "case.h"

enum { N = 12000, M = 800 };
typedef struct vector {
    double x, y, z;
} vector;
static int edge[N][2];
static double x[M][3], h[M], most[M], b[M][3], bb[M][3];
static vector force[M];
static int count[M];
static struct cell {
    double low, high;
    int visits;
} cell[M];

static inline void add(double *target, double value) {
    *target += value;
}

static void through_pointer(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        add(&h[edge[t][0]], x[edge[t][1]][0]);
        add(h + edge[t][1], x[edge[t][0]][1]);
    }
}

static void raise_to(double *place, double v) {
    if (*place < v)
        *place = v;
}

static void set(double *place, double v) {
    *place = v;
}

static void grow(double *place) {
    *place = *place * 0.5 + 1.0;
}

static void set_and_grown(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[edge[t][0]] += 1.0;
        set(&h[t % M], 0.25);
        grow(&h[edge[t][1]]);
    }
}

static void visit(int *visits) {
    ++*visits;
}

static void of_members(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        raise_to(&most[edge[t][0]], x[edge[t][1]][2]);
        raise_to(&cell[edge[t][1]].high, x[edge[t][0]][0]);
        visit(&cell[edge[t][0]].visits);
        count[edge[t][1]] += 1;
    }
}

static void add_scaled(double to[3], double scale, const double from[3]) {
    for (int c = 0; c < 3; c++)
        to[c] += scale * from[c];
}

static void add_twice(double *to, const double *from) {
    to[0] += from[0];
    to[1] -= from[1];
    add_scaled(to, 0.5, from);
}

static void rows(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = edge[t][0], j = edge[t][1];
        const double f[3] = {x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]};
        add_scaled(b[i], 1.0, f);
        add_scaled(b[j], -1.0, f);
        add_twice(bb[j], x[i]);
        bb[i][1] *= 0.75;
    }
}

static void vector_add(vector *to, vector v) {
    to->x += v.x;
    to->y += v.y;
    to->z += v.z;
}

static void records(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double *p = x[edge[t][0]];
        const vector v = {p[0], p[1], p[2]};
        vector_add(&force[edge[t][1]], v);
    }
}

/* ---- the array is a member of a struct, and the function gets the struct's address ---- */

typedef struct matrix {
    int columns;
    double *value;
} matrix;
static double entries[M * M];
static matrix shared = {3, entries};

static void matrix_add(const matrix *m, int row, int column, double v) {
    m->value[row * m->columns + column] += v;
}

static int column_of(const int *shift, int k) {
    return (k + *shift) % 3;
}

static void ends_of(const int *pair, int *first, int *second) {
    *first = pair[0];
    *second = pair[1];
}

static void found_by_address(int n) {
    int i, j;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        ends_of(edge[t], &i, &j);
        h[i] += 0.25;
        h[j] -= x[i][0];
    }
}

static double by_address_of_a_struct(int n, int columns) {
    matrix m = {columns, entries};
    int shift = columns;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        matrix_add(&m, edge[t][0], edge[t][1] % 3, 0.1 * (t % 7));
    for (int t = 0; t < n; t++) // EXPECT: transformed
        matrix_add(&shared, edge[t][1], edge[t][0] % 3, 0.3 * (t % 5));
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[column_of(&shift, edge[t][0])] += x[edge[t][1]][2];
    return m.value[5] + shift;
}

int main(void) {
    case_values(&x[0][0], 3 * M);
    for (int round = 0; round < 3; round++) {
        case_subscripts(&edge[0][0], 2 * N, M);
        through_pointer(N);
        set_and_grown(N);
        of_members(N);
        rows(N);
        records(N);
        found_by_address(N);
        const double sum = by_address_of_a_struct(N, 3 + round % 2);
        case_print("sum", &sum, sizeof sum);
        case_print("entries", entries, sizeof entries);
        CASE_PRINT(h);
        CASE_PRINT(most);
        CASE_PRINT(count);
        CASE_PRINT(b);
        CASE_PRINT(bb);
        CASE_PRINT(force);
        for (int i = 0; i < M; i++) {
            case_print("high", &cell[i].high, sizeof cell[i].high);
            case_print("visits", &cell[i].visits, sizeof cell[i].visits);
        }
    }
    return 0;
}
