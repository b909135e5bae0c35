/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A look-up function reads at a subscript that its local enumerator determines. The caller has another enumerator of
 * that name, or none. The elements compared from call to call must be those that the function reads. */
#include <stdio.h>

enum { SIZE = 9000, COUNT = 2000, ROWS = 64 };

static int table[SIZE];
static double h[ROWS];

static int look(const int *a, int t) {
    enum { N = 4000 };
    return a[t + N];
}

static int look_before(int t) {
    enum { FIRST = 6000, STEP = 1 };
    return table[FIRST + STEP * t];
}

enum { SHARED = 100 };

static int look_hidden(const int *a, int t) {
    enum { SHARED = 5000 };
    return a[t + SHARED];
}

static int look_shared(const int *a, int t) {
    return a[t + SHARED];
}

static int look_in_a_block(const int *a, int t) {
    int at = t;
    {
        enum { N = 3000 };
        at += N;
    }
    return a[at];
}

static void fill(int from, int seed) {
    for (int t = 0; t < COUNT; t++)
        table[from + t] = (t * 13 + seed) % ROWS;
}

static void own_name(int n) {
    enum { N = 1 };
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[look(table, t)] += 0.1 * N;
}

static void no_name(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[look_before(t)] += 0.2;
}

static void hidden(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[look_hidden(table, t)] += 0.1 * SHARED;
}

static void shared(int n) {
    enum { SHARED = 7 };
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[look_shared(table, t)] += 0.1 * SHARED;
}

static void variable_of_that_name(int n, int N) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[look_in_a_block(table, t)] += 0.1 * N;
}

/* the table is a later part of the updated array: a guard must detect the overlap */
static int cells[SIZE];

static int far(const int *a, int t) {
    enum { N = 4000 };
    return a[t + N];
}

static void overlapping(int n, int *to, const int *from, const int *k) {
    enum { N = 8000 };
    (void)N;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[k[t]] += 1 + far(from, t);
}

int main(void) {
    static int k[COUNT];
    for (int round = 0; round < 6; round++) {
        fill(4000, round);
        own_name(COUNT);
        fill(6000, 3 * round);
        no_name(COUNT);
        fill(5000, 5 * round);
        hidden(COUNT);
        fill(100, 7 * round);
        shared(COUNT);
        fill(3000, 9 * round);
        variable_of_that_name(COUNT, 2);
        for (int t = 0; t < COUNT; t++)
            k[t] = 4000 + t * 7 % 100;
        overlapping(100, cells, cells, k);
    }
    for (int i = 0; i < ROWS; i++)
        printf("%a %d\n", h[i], cells[4000 + i]);
    return 0;
}
