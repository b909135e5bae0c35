/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Pointers that may overlap: in each call whose arrays overlap, the guard runs the sequential loop instead.
// covers: row 29, row 30, row 54 of docs/constructs.md
// MAY-RUN-SERIALLY: in some calls the arrays overlap
#include "case.h"
#include <string.h>

enum { N = 9000, M = 2000 };
static double memory[3 * M];
static int index_memory[2 * N];

static void gather_scatter(double *b, const double *x, const int *s, const int *r, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += 0.5 * x[r[t]];
}

static void affine_source(double *b, const double *v, const int *s, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += v[t % 7] + v[t];
}

static void two_targets(double *a, double *b, const int *s, const int *r, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        a[s[t]] += 1.0 + t;
        b[r[t]] += 0.125 * t;
    }
}

static void two_operators(double *a, double *b, const int *s, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        a[s[t]] += 3.0;
        b[s[t]] *= 0.5;
    }
}

/* Pointers to bytes may alias any object, the pointers in `struct image` included. */
struct image {
    unsigned char *pixel;
    const int *at;
    int count;
};

static void bytes(struct image *i) {
    for (int t = 0; t < i->count; t++) // EXPECT: transformed
        i->pixel[i->at[t]] += 3;
}

/* Counts and subscripts are both int: the loop may change subscripts that later iterations read. */
static void own_subscripts(int *count, const int *s, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        count[s[t]] += 1;
}

static void bound_in_memory(int *count, const int *s, const int *n) {
    for (int t = 0; t < *n; t++) // EXPECT: transformed
        count[s[t]] += 1;
}

static void restricted(double *restrict b, const double *restrict x, const int *restrict s, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += x[s[t]] * x[t % 100];
}

static void show(void) {
    CASE_PRINT(memory);
    CASE_PRINT(index_memory);
}

int main(void) {
    static int s[N], r[N];
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        case_subscripts(r, N, M);
        case_values(memory, 3 * M);
        gather_scatter(memory, memory + M, s, r, N); /* disjoint */
        show();
        gather_scatter(memory, memory, s, r, N); /* one array for both */
        show();
        gather_scatter(memory + 100, memory, s, r, N); /* overlapping, 100 elements apart */
        show();
        for (int i = 0; i < 3 * M; i++)
            memory[i] = case_value();
        affine_source(memory, memory + M, s, M); /* disjoint */
        show();
        affine_source(memory, memory + M - 1, s, M); /* one common element */
        show();
        two_targets(memory, memory + M, s, r, N);
        show();
        two_targets(memory, memory, s, r, N);
        show();
        two_targets(memory, memory + 12, s, r, N);
        show();
        two_operators(memory, memory + M, s, N);
        show();
        two_operators(memory, memory + 1, s, N);
        show();
        case_values(memory, 3 * M);
        struct image picture = {(unsigned char *)memory, s, M};
        bytes(&picture);
        show();
        picture.pixel = (unsigned char *)&picture.count;
        for (int t = 0; t < M; t++)
            r[t] = 1; /* 3 added here changes the second byte of the trip count */
        picture.at = r;
        picture.count = 100;
        bytes(&picture);
        case_print("count", &picture.count, sizeof picture.count);
        case_subscripts(r, N, M);
        case_values(memory, 3 * M);
        for (int i = 0; i < 2 * N; i++)
            index_memory[i] = case_below(1000);
        own_subscripts(index_memory + N, index_memory, N);
        show();
        own_subscripts(index_memory, index_memory, N);
        show();
        own_subscripts(index_memory + 500, index_memory, N);
        show();
        index_memory[7] = N / 2;
        bound_in_memory(index_memory + N, index_memory + 10, &index_memory[7]);
        show();
        for (int i = 0; i < N; i++)
            s[i] %= 30;
        bound_in_memory(index_memory, s, &index_memory[7]); /* updates its own bound */
        show();
        restricted(memory, memory + M, s, M);
        show();
    }
    return 0;
}
