/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A look-up function uses its own struct type in a sizeof or a cast; the caller has another type
 * with that tag. */
#include <stdio.h>

enum { SIZE = 40000, COUNT = 2000, ROWS = 64 };

static int table[SIZE];
static double h[ROWS];

struct row {
    int a[2];
};

static int by_size(const int *a, int t) {
    struct row {
        int a[4000];
    };
    return a[t + (int)(sizeof(struct row) / sizeof(int))];
}

static int by_cast(const int *a, int t) {
    struct row {
        int before[6000], a;
    };
    return ((const struct row *)(a + t))->a;
}

static int by_union(const int *a, int t) {
    union row {
        int a[9000];
        char c;
    };
    return a[t + (int)sizeof(union row) / 4];
}

static int by_typedef(const int *a, int t) {
    typedef struct {
        int a[11000];
    } row;
    return a[t + (int)(sizeof(row) / sizeof(int))];
}

static int by_variable(const int *a, int t) {
    int length[13000];
    return a[t + (int)(sizeof length / sizeof length[0])];
}

static void fill(int from, int seed) {
    for (int t = 0; t < COUNT; t++)
        table[from + t] = (t * 13 + seed) % ROWS;
}

static void size_of_other(int n) {
    struct row {
        int a[16];
    };
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[by_size(table, t)] += (double)sizeof(struct row);
}

static void size_of_none(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[by_size(table, t)] += (double)sizeof(struct row);
}

static void cast_to_other(int n) {
    struct row {
        int a, before[2];
    };
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[by_cast(table, t)] += (double)sizeof(struct row);
}

static void cast_to_none(int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[by_cast(table, t)] += 0.5;
}

static void union_of_none(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[by_union(table, t)] += 0.5;
}

static void typedef_and_variable(int n) {
    int row[3], length[2] = {1, 2};
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[by_typedef(table, t)] += (double)sizeof row;
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[by_variable(table, t)] += length[t % 2];
}

static void neighbour(int n) {
    const struct row *rows = (const struct row *)table;
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[rows[t].a[1]] += 0.5;
}

int main(void) {
    for (int round = 0; round < 5; round++) {
        fill(4000, round);
        size_of_other(COUNT);
        fill(4000, round * 3);
        size_of_none(COUNT);
        fill(6000, round * 5);
        cast_to_other(COUNT);
        fill(6000, round * 7);
        cast_to_none(COUNT);
        fill(9000, round * 9);
        union_of_none(COUNT);
        fill(11000, round * 11);
        fill(13000, round * 11 + 2);
        typedef_and_variable(COUNT);
        fill(0, round + 1);
        neighbour(COUNT / 2);
    }
    for (int i = 0; i < ROWS; i++)
        printf("%a\n", h[i]);
    return 0;
}
