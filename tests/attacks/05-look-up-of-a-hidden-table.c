/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A look-up function reads a table of the file. In the scope of the caller's loop the table's name
 * means something else. */
#include <stdio.h>

enum { SIZE = 4000, ROWS = 64 };

static int tab[SIZE];
static int offset;
static double h[ROWS];

static int look(int t) {
    return tab[t];
}

static int look_behind(int t) {
    return tab[t + offset];
}

static int other[SIZE];

static int look_other(int t) {
    return other[t];
}

static int own_table(int t) {
    static const int tab[4] = {3, 1, 2, 0};
    return tab[t % 4];
}

static void in_a_static(int n) {
    static int tab[SIZE];
    tab[0]++;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[look(t)] += 0.1 * tab[0];
}

static void in_a_block(int n) {
    for (int round = 0; round < 1; round++) {
        static const double tab[2] = {1, 2};
        for (int t = 0; t < n; t++) // EXPECT: transformed
            h[look(t)] += 0.1 * tab[t % 2];
    }
}

static void in_an_enumerator(int n) {
    enum { tab = 5, offset = 6 };
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[look_behind(t)] += 0.1 * tab + offset;
}

static void in_a_type(int n) {
    typedef double tab;
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[look(t)] += (tab)0.3;
}

static int inner[SIZE];

static int look_inside(int t) {
    return inner[t];
}

static void in_an_inner_block(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int row = look_inside(t);
        {
            double inner = 0.7;
            h[row] += inner;
        }
    }
}

static void with_its_own(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[own_table(t)] += 0.1;
}

/* the table is declared further below */
static int look_later(int t);

static void before_the_declaration(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[look_later(t)] += 0.1;
}

static int later[SIZE];

static int look_later(int t) {
    return later[t];
}

static int cast[SIZE];

static int look_cast(int t) {
    return cast[t];
}

static void in_a_sizeof(int n) {
    const int bytes = (int)sizeof(enum { cast = 3 });
    for (int t = 0; t < n; t++) // EXPECT: refuse binding
        h[look_cast(t)] += bytes + cast;
}

static void neighbour(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[look_other(t)] += 0.1;
}

int main(void) {
    for (int round = 0; round < 5; round++) {
        for (int t = 0; t < SIZE; t++)
            tab[t] = later[t] = inner[t] = other[t] = cast[t] = (t * 5 + round * 11) % ROWS;
        in_a_static(SIZE / 2);
        in_a_block(SIZE / 2);
        in_an_enumerator(SIZE / 2);
        in_a_type(SIZE / 2);
        in_an_inner_block(SIZE / 2);
        with_its_own(SIZE / 2);
        before_the_declaration(SIZE / 2);
        in_a_sizeof(SIZE / 2);
        neighbour(SIZE / 2);
    }
    for (int i = 0; i < ROWS; i++)
        printf("%a\n", h[i]);
    return 0;
}
