/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A restrict pointer declared in the loop's body holds for one iteration (C17 6.7.3.1p2: its block
// is the body). In different iterations the pointers may lead into one array.
#include <stdio.h>

enum { N = 20000 };
static double both[N + 1], apart[N + 1], other[N + 1];
static int k[N];

__attribute__((noinline)) static double *same(double *p) {
    return p;
}

/* the pointer is a function's result, so its array is not known to be `b` */
static void called(int n, const int *s, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse
        const double *restrict x = same(b);
        b[s[t]] += 0.5 * x[t] + 1.0;
    }
}

/* another function set the pointer before the loop, and the loop reads it */
static double *kept;

static void kept_elsewhere(int n, const int *s, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double *restrict x = kept;
        b[s[t]] += 0.5 * x[t] + 1.0;
    }
}

/* declared in a block inside the body */
static void inner_block(int n, const int *s, double *b, double **table) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse may-alias
        if (s[t] != t) {
            const double *restrict x = table[0];
            b[s[t]] += 0.5 * x[t] + 1.0;
        }
    }
}

/* declared around the loop, the promise holds for all iterations */
static void around(int n, const int *s, double *b, double *p) {
    const double *restrict x = p;
    for (int t = 0; t < n; t++) // EXPECT: parallel
        b[s[t]] += 0.5 * x[t] + 1.0;
}

static void parameter(int n, const int *s, double *b, const double *restrict x) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        b[s[t]] += 0.5 * x[t] + 1.0;
}

static void print(const char *name, const double *v) {
    double sum = 0;
    for (int i = 0; i < N; i++)
        sum = sum * 0.999 + v[i];
    printf("%s %a\n", name, sum);
}

static void fill(double *v) {
    for (int i = 0; i < N; i++)
        v[i] = i % 17;
}

int main(void) {
    /* iteration t reads element t and updates another one, so no iteration breaks the promise */
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + 1) % N);
    for (int t = 0; t < N; t++)
        if (k[t] == t)
            k[t] = (t + 1) % N;
    for (int round = 0; round < 3; round++) {
        fill(both);
        called(N, k, both);
        print("called", both);
        fill(both);
        kept = both;
        kept_elsewhere(N, k, both);
        print("kept", both);
        fill(both);
        double *table[1] = {both};
        inner_block(N, k, both, table);
        print("inner", both);
        fill(apart);
        fill(other);
        around(N, k, apart, other);
        parameter(N, k, apart, other);
        print("apart", apart);
    }
    return 0;
}
