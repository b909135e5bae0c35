/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// THREADS: 2 7
// METHODS: auto binning localwrite
// LINK: -lm
// An update changes a value that a translation reads once before the loop, or stores after it: the bound, an operand
// or an own element. It does so late, after binning and the sequential loop have executed many iterations.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 300000, M = 1000 };
static int memory[M + N];
static double x[N + 8];

static void bound(int *b, const int *n) {
    for (int i = 0; i < *n; i++) { // EXPECT: transformed
        double s = sqrt(x[i]) + sqrt(x[i] + 2) + sqrt(x[i] + 3);
        b[(int)s] += 1;
    }
}

/* The subscripts cannot be computed twice, so the first execution is a trial of binning. */
static void operand(int *b, int n, int w) {
    int *p = &w;
    if (!b)
        b = p;
    for (int i = 0; i < n; i++) {
        double s = pow(x[i], 0.51) + pow(x[i], 0.52) + pow(x[i], 0.53);
        if (s < 1)
            b[(int)s] += w;
    }
    printf("w %d\n", w);
}

static void bound_once(int *b, const int *n) {
    for (int i = 0; i < *n; i++) {
        double s = pow(x[i], 0.51) + pow(x[i] + 2, 0.52) + pow(x[i] + 3, 0.53);
        b[(int)s] += 1;
    }
}

/* Iteration i has the own element z[i], which is stored after all iterations. */
static int own(int *b, int *z, int n) {
    int changed = 0;
    for (int i = 0; i < n; i++) {
        double s = pow(x[i], 0.51) + pow(x[i] + 2, 0.52) + pow(x[i] + 3, 0.53);
        int k = (int)s;
        if (z[i] != k)
            changed++;
        z[i] = k;
        b[k] += 1;
    }
    return changed;
}

static void print_all(void) {
    unsigned sum = 0;
    for (int k = 0; k < M + N; k++)
        sum = sum * 31 + (unsigned)memory[k];
    printf("%d %u\n", memory[3], sum);
}

static void all(int hit) {
    for (int i = 0; i < N + 8; i++)
        x[i] = 30 + i * 2654435761u % 9000;
    x[hit] = 0; /* here the subscript is 3 */
    for (int k = 0; k < M; k++)
        memory[k] = 0;
    memory[3] = N;
    bound(memory, memory + 3);
    print_all();
    memory[3] = N;
    bound_once(memory, memory + 3);
    print_all();
    x[hit] = 90000; /* the update hits the own element of an early iteration */
    for (int k = 0; k < M + N; k++)
        memory[k] = 0;
    printf("%d\n", own(memory, memory + M, N));
    print_all();
}

int main(void) {
    const int hits[] = {N / 10, N / 2, N - 1, N / 10, N / 2, N - 1};
    for (unsigned h = 0; h < sizeof hits / sizeof *hits; h++)
        all(hits[h]);
    for (int i = 0; i < N; i++)
        x[i] = i / 3 == N / 30 ? 0 : 30;
    operand(NULL, N, 3);
    return 0;
}
