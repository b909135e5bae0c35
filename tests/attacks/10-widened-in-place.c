/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Memory of malloc has the type of the value stored last (C17 6.5p6). Iterations read floats, and later ones store
// doubles over floats already read. So types do not show that the arrays are disjoint.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { N = 20000 };
static short count[N];

/* element t has 8 bytes and overwrites floats 2t and 2t + 1, which earlier iterations have read */
static void widen(int n, const int *k, const float *v, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        count[k[t]]++;
        h[k[t]] = v[n - 1 - t];
    }
}

/* stores floats over integers of the same size */
static void convert(int n, const int *restrict k, const int *v, float *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        count[k[t]]++;
        h[k[t]] = (float)v[n - 1 - t] * 0.5f;
    }
}

/* the subscripts of the reads are from a table, and the inspector records them */
static void gathered(int n, const int *restrict k, const int *restrict from, const int *v, float *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        count[k[t]]++;
        h[k[t]] = (float)v[from[t]] * 0.5f;
    }
}

static void records(int n, const int *restrict k, const long *v, struct pair { float a, b; } *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse text
        count[k[t]]++;
        h[k[t]].a = (float)v[n - 1 - t];
        h[k[t]].b = 1.0f;
    }
}

static void store(float *to, float v) {
    *to = v;
}

static void by_call(int n, const int *restrict k, const int *v, float *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        count[k[t]]++;
        store(&h[k[t]], (float)v[n - 1 - t]);
    }
}

/* disjoint arrays: the loops run in parallel; a loop that reads its own element first needs no guard */
static void stored_apart(int n, const int *k, const float *v, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        count[k[t]]++;
        h[k[t]] = v[t];
    }
}

static void accumulated(int n, const int *k, const float *v, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += v[t];
}

static void largest(int n, const int *k, const float *v, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        if (h[k[t]] < v[t])
            h[k[t]] = v[t];
}

static void print(const char *name, const void *memory, size_t bytes) {
    const unsigned char *byte = memory;
    unsigned long long hash = 1469598103934665603ull;
    for (size_t i = 0; i < bytes; i++)
        hash = (hash ^ byte[i]) * 1099511628211ull;
    printf("%s %llx\n", name, hash);
}

int main(void) {
    int *down = malloc(N * sizeof *down), *k = malloc(N * sizeof *k);
    for (int t = 0; t < N; t++) {
        down[t] = N - 1 - t;
        k[t] = (int)(t * 7919LL % N);
    }
    for (int round = 0; round < 3; round++) {
        float *v = malloc(N * sizeof(double));
        for (int t = 0; t < N; t++)
            v[t] = (float)t * 0.25f;
        widen(N, down, v, (double *)(void *)v);
        print("widen", v, N * sizeof(double));
        int *w = malloc(N * sizeof *w);
        for (int t = 0; t < N; t++)
            w[t] = t * 3 + round;
        convert(N, down, w, (float *)(void *)w);
        print("convert", w, N * sizeof *w);
        for (int t = 0; t < N; t++)
            w[t] = t * 5 + round;
        gathered(N, down, down, w, (float *)(void *)w);
        print("gathered", w, N * sizeof *w);
        for (int t = 0; t < N; t++)
            w[t] = t * 7 + round;
        by_call(N, down, w, (float *)(void *)w);
        print("by_call", w, N * sizeof *w);
        long *l = malloc(N * sizeof *l);
        for (int t = 0; t < N; t++)
            l[t] = t * 3 + round;
        records(N, down, l, (struct pair *)(void *)l);
        print("records", l, N * sizeof *l);
        float *apart = malloc(N * sizeof *apart);
        double *h = calloc(N, sizeof *h);
        for (int t = 0; t < N; t++)
            apart[t] = (float)t;
        stored_apart(N, k, apart, h);
        accumulated(N, k, apart, h);
        largest(N, k, apart, h);
        print("apart", h, N * sizeof *h);
        free(v);
        free(w);
        free(l);
        free(apart);
        free(h);
    }
    print("count", count, sizeof count);
    free(down);
    free(k);
    return 0;
}
