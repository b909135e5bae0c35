/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Rows between which the loop reads other data: the run-time guard detects the overlap, and the original loop runs.
// MAY-RUN-SERIALLY: rows and reads overlap
// covers: row 48 of docs/constructs.md
#include "case.h"

#include <string.h>

enum { N = 3000, ROWS = 40, WIDTH = 8 };
static double block[2 * ROWS][WIDTH], e[N], *to[ROWS], *from[N];
static int s[N];

static void values_among_rows(int n, double **rows, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        rows[s[t]][t % WIDTH] += v[t % (ROWS * WIDTH)] * 0.5;
}

static void rows_among_rows(int n, double **rows, double **others) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        rows[s[t]][1] += others[t][0] * 0.5;
}

/* The loop updates elements that lie inside a row which it reads. */
static void within_a_row(int n, double *out, double **others) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < WIDTH; c++)
            out[s[t] % 2] += others[t][c] * 0.25;
}

/* Pointers to char may alias anything, the table of rows included. */
static void table_in_a_row(int n, char **rows) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        rows[s[t]][0]++;
}

int main(void) {
    case_values(e, N);
    case_values(&block[0][0], 2 * ROWS * WIDTH);
    case_subscripts(s, N, ROWS);
    for (int i = 0; i < ROWS; i++)
        to[i] = block[2 * i];
    values_among_rows(N, to, &block[0][0]);
    values_among_rows(N, to, block[1]);
    values_among_rows(N, to, e);
    CASE_PRINT(block);
    for (int t = 0; t < N; t++)
        from[t] = block[(t * 7) % (2 * ROWS)];
    rows_among_rows(N, to, from);
    rows_among_rows(N, to, from);
    CASE_PRINT(block);
    for (int t = 0; t < N; t++)
        from[t] = &e[t];
    rows_among_rows(N, to, from); /* disjoint: runs in parallel */
    rows_among_rows(N, to, from);
    from[N / 2] = to[3]; /* now a row that is read is also updated */
    rows_among_rows(N, to, from);
    from[N / 2] = e;
    to[3] = &e[N - 3];
    rows_among_rows(N, to, from);
    CASE_PRINT(block);
    CASE_PRINT(e);
    for (int t = 0; t < N; t++)
        from[t] = block[2 * (t % ROWS)];
    within_a_row(N, &block[11][3], from); /* disjoint */
    within_a_row(N, &block[11][3], from);
    from[N / 2] = block[11];
    within_a_row(N, &block[11][3], from);
    CASE_PRINT(block);
    /* The table lies among its rows, and row 3 is the pointer to row 0 itself. Each update of row 3 moves row 0 by one
     * byte. */
    char *const bytes = memset(aligned_alloc(4096, 4096), 0, 4096);
    char **const table = (char **)(void *)(bytes + 2048);
    for (int i = 0; i < ROWS; i++)
        table[i] = i == 3 ? (char *)table : bytes + (i % 2 ? 3000 : 1000) + i;
    table_in_a_row(N, table);
    table_in_a_row(N, table);
    case_print("before the table", bytes, 2048);
    case_print("after the table", bytes + 3000, 1096);
    return 0;
}
