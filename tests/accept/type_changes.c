/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A store gives allocated memory another type (C17 6.5p6). Here it overwrites sums in memory and own elements, which
// the loop stores only at its end. So their types do not show that they are disjoint, and a guard compares addresses.
// MAY-RUN-SERIALLY: in some calls the arrays overlap
// INTEGERS: no
// covers: row 59, row 93 of docs/constructs.md
#include "case.h"

enum { N = 3000, M = 300 };
static short k[N], x[N];
static float y[N];
static double g[M];

/* The last iterations store over the sum after its last update. */
static void sum_and_store(int n, double *restrict to, int *sum, float *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        to[k[t]] += 0.5;
        if (t < n / 2)
            *sum += x[t];
        h[t] = y[t];
    }
}

/* The store is conditional, and its subscript comes from a table. */
static void sum_and_scattered(int n, double *restrict to, long *sum, float *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        to[k[t]] -= 0.5;
        *sum -= x[t];
        if (t == n - 1)
            h[k[t]] = y[t];
    }
}

/* Iteration t stores to e[t] only after the loop, which overwrites the sum if both are the same memory. */
static int sum_and_own(int n, double *restrict to, int *restrict mark, int *sum, float *e) {
    int changes = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        e[t] = y[t];
        if (mark[t] != k[t])
            changes++;
        mark[t] = k[t];
        to[k[t]] += 0.25;
        if (t < n / 2)
            *sum += x[t];
    }
    return changes;
}

/* Each iteration reads an integer and stores a float over it. */
static void two_own(int n, double *restrict to, int *mark, float *e) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int before = mark[t];
        e[t] = 0.25f * (float)x[t];
        if (x[t] > 2)
            mark[t] = before + 1;
        to[k[t]] += before;
    }
}

/* Two sums and an array, all read before they are stored: here types alone show that they are disjoint. */
static void read_first(int n, double *restrict to, double *h, int *sum, float *other) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        to[k[t]] += 0.5;
        h[k[t]] += 0.125;
        *sum += x[t];
        *other += y[t];
    }
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = (short)case_below(M);
        x[t] = (short)case_below(5);
        y[t] = (float)case_value();
    }
    for (int round = 0; round < 3; round++) {
        const size_t bytes = 2 * N * sizeof(long);
        int *memory = malloc(bytes), *apart = malloc(bytes), mark[N];
        for (int t = 0; t < N; t++) {
            memory[t] = apart[t] = t;
            mark[t] = k[t] - t % 2;
        }
        void *last = &memory[N - 7];
        sum_and_store(N, g, last, (float *)(void *)memory);
        sum_and_store(N, g, &apart[3], (float *)(void *)memory);
        case_print("sum_and_store", memory, N * sizeof *memory);

        ((long *)(void *)memory)[M / 2] = 7;
        k[N - 1] = (short)(M + round % 2);
        double *wide = malloc((M + 2) * sizeof *wide);
        for (int t = 0; t < M + 2; t++)
            wide[t] = 0;
        last = &((long *)(void *)memory)[M / 2];
        sum_and_scattered(N, wide, last, (float *)(void *)memory);
        k[N - 1] = 0;
        case_print("sum_and_scattered", memory, N * sizeof *memory);
        free(wide);

        for (int t = 0; t < N; t++)
            memory[t] = t;
        last = &memory[N - 7];
        int changes = sum_and_own(N, g, mark, last, (float *)(void *)memory);
        changes += sum_and_own(N, g, mark, &apart[4], (float *)(void *)memory);
        printf("%d changes\n", changes);
        case_print("sum_and_own", memory, N * sizeof *memory);

        for (int t = 0; t < N; t++)
            memory[t] = t;
        two_own(N, g, memory, (float *)(void *)memory);
        case_print("two_own", memory, N * sizeof *memory);
        two_own(N, g, apart, (float *)(void *)memory);
        case_print("apart", apart, N * sizeof *apart);

        float other = 0.5f;
        double h[M] = {0};
        read_first(N, g, h, &apart[5], &other);
        printf("%d %a\n", apart[5], (double)other);
        CASE_PRINT(h);
        free(memory);
        free(apart);
    }
    CASE_PRINT(g);
    return 0;
}
