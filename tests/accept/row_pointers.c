/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Elements reached through pointers in memory: the owner of an element is determined by its address.
// INTEGERS: no
// covers: row 48, row 49 of docs/constructs.md
#include "case.h"

#include <string.h>

enum { N = 2500, ROWS = 60, WIDTH = 10 };
typedef double *row_pointer;
struct table {
    int width;
    double *row[ROWS];
    row_pointer *way;
};
struct object {
    double *data;
    struct object *next;
};
static int s[N], second[N], many[ROWS];
static double e[N], block[ROWS][WIDTH], sum[ROWS];
static double *at[ROWS];
static double **way[3];
static struct table table;
static struct object object[ROWS];
static long counted[ROWS], *counter[ROWS];
static signed char letters[ROWS][WIDTH], *letter[ROWS];

static void one_column(int first, int n, double **rows) {
    for (int t = first; t < n; t++) // EXPECT: transformed
        rows[s[t]][t % WIDTH] += e[t];
}

static void all_columns(int n, int width, double **rows) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int k = s[t];
        for (int c = 0; c < width; c++)
            rows[k][c] += e[t] * c;
        sum[k] += 1.0 / (1 + t);
    }
}

static void two_rows(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (e[t] > -0.5)
            at[s[t]][0] += e[t];
        at[second[t]][1] -= e[t];
        at[second[t]][0] = 0.5 * e[t] - at[second[t]][0];
        if (at[s[t]][2] < e[t])
            at[s[t]][2] = e[t];
    }
}

static void of_structure(struct table *p, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p->row[s[t]][t & 3] += e[t];
        for (int c = 0; c < p->width; c++)
            p->row[second[t]][c] *= 0.5;
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        p->way[s[t]][5] += e[t];
}

static void by_local_pointer(int n, double **rows) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *row = rows[s[t]], *other;
        other = rows[second[t]];
        row[0] += e[t];
        other[3] -= e[t];
        *row += 1.0;
    }
}

static void add(double *to, double value) {
    *to += value;
}

static void by_function(int n, double **rows) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        add(&rows[s[t]][second[t] % WIDTH], e[t]);
}

static void members(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        struct object *o = &object[s[t]];
        o->data[t & 1] += e[t];
        many[second[t]]++;
        object[s[t]].next->data[2] -= e[t];
    }
}

static void counters(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        *counter[s[t]] += t;
}

static void characters(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        letter[s[t]][t % WIDTH]++;
}

/* Pointers that are the same in all iterations are treated as arrays. */
static void components(int n, double **force) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        force[0][s[t] % WIDTH] += e[t];
        force[1][second[t] % WIDTH] -= e[t];
    }
}

static void tables_of_tables(int n, double ***tables) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        tables[t % 3][s[t]][1] += e[t];
}

static void all_loops(void) {
    one_column(0, N, at);
    one_column(5, 6, at);
    one_column(5, 5, at);
    one_column(9, -3, at);
    all_columns(N, WIDTH, at);
    all_columns(N, 0, at);
    two_rows(N);
    of_structure(&table, N);
    by_local_pointer(N, at);
    by_function(N, at);
    members(N);
    components(N, at);
    tables_of_tables(N, way);
}

static void show(const char *name) {
    for (int i = 0; i < ROWS; i++)
        case_print(name, at[i], WIDTH * sizeof(double));
    CASE_PRINT(block);
    CASE_PRINT(sum);
}

static void take_rows(void) {
    memcpy(table.row, at, sizeof at);
    table.way = at;
    table.width = 4;
    for (int i = 0; i < 3; i++)
        way[i] = i == 1 ? table.row : at;
    for (int i = 0; i < ROWS; i++)
        object[i] = (struct object){at[i], &object[(i * 7 + 1) % ROWS]};
}

static void with_rows(const char *name) {
    take_rows();
    all_loops();
    all_loops(); /* with the plans made by the first call */
    show(name);
    CASE_PRINT(many);
}

static void allocate_each(void) {
    for (int i = 0; i < ROWS; i++) {
        at[i] = malloc(WIDTH * sizeof(double));
        case_values(at[i], WIDTH);
    }
}

int main(void) {
    case_values(e, N);
    case_values(&block[0][0], ROWS * WIDTH);
    case_subscripts(s, N, ROWS);
    case_subscripts(second, N, ROWS);
    for (int i = 0; i < ROWS; i++)
        at[i] = block[i];
    with_rows("in one block");
    for (int i = 0; i < ROWS; i++)
        at[i] = block[(i * 37 + 11) % ROWS];
    with_rows("shuffled");
    for (int i = 0; i < ROWS; i++)
        at[i] = block[i / 2];
    with_rows("two pointers to each");
    for (int i = 0; i < ROWS; i++)
        at[i] = &block[0][0] + i * (WIDTH / 2);
    with_rows("each half in the next");
    allocate_each();
    with_rows("allocated each");
    all_loops();
    for (int i = 0; i < ROWS; i += 3) { /* moves some rows, while the table of pointers stays in place */
        double *moved = malloc(3 * WIDTH * sizeof(double));
        memcpy(moved, at[i], WIDTH * sizeof(double));
        free(at[i]);
        at[i] = moved;
    }
    with_rows("moved");
    double *const first = at[0];
    at[0] = at[1];
    at[1] = first;
    all_loops();
    show("exchanged");
    at[5] = at[6];
    all_loops();
    show("one twice");
    for (int i = 0; i < N; i += 7)
        s[i] = second[i];
    with_rows("other subscripts");
    for (int i = 0; i < ROWS; i++) {
        counter[i] = &counted[(i * 5) % ROWS];
        letter[i] = letters[ROWS - 1 - i];
    }
    for (int round = 0; round < 3; round++) {
        counters(N);
        characters(N);
        counter[round] = &counted[50];
        letter[round] = letters[50];
    }
    CASE_PRINT(counted);
    CASE_PRINT(letters);
    return 0;
}
