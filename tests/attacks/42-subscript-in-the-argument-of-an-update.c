/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The subscript is part of the updating function's argument, h + s[t]. If the table changes between
 * two executions, the plan must not be kept. */
#include <stdio.h>

enum { SIZE = 6000, ROWS = 64 };
static int s[SIZE], shift;
static double h[ROWS + 8], g[ROWS + 8];

static void add(double *to, double value) {
    *to = *to * 0.9375 + value;
}

static void add_at(double *to, int k, double value) {
    to[k] = to[k] * 0.9375 + value;
}

static void by_sum(int n, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        add(to + s[t], 0.1 * t);
}

static void by_sum_with_a_scalar(int n, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        add(s[t] + (to + shift), 0.3 * t);
}

static void by_subscript(int n, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        add_at(to, s[t] + shift, 0.2 * t);
}

static void neighbour(int n, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        to[s[t]] = to[s[t]] * 0.9375 + 0.7 * t;
}

int main(void) {
    for (int round = 0; round < 6; round++) {
        for (int t = 0; t < SIZE; t++)
            s[t] = (t * 5 + round * (t % 7)) % ROWS;
        shift = round;
        by_sum(SIZE, h);
        by_sum_with_a_scalar(SIZE, g);
        by_subscript(SIZE, h);
        neighbour(SIZE, g);
    }
    for (int i = 0; i < ROWS + 8; i++)
        printf("%a %a\n", h[i], g[i]);
    return 0;
}
