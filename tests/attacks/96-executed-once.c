/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// THREADS: 1 2 3 7 16
// METHODS: auto
// LINK: -lm
// Long loops that are executed once. `auto` executes their first iterations in order and the others as a separate loop.
// This must change neither values that depend on the iteration's number, nor values after the loop, nor whether
// overlaps are detected.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 3000, M = 2000, ROWS = 500, BEYOND = 100 }; /* no iteration reads the last BEYOND elements */
static double x[N + BEYOND], all[ROWS + 2 * N + BEYOND];
static int key[N + BEYOND];

static void print(const double *h) {
    const unsigned char *bytes = (const unsigned char *)h;
    unsigned long long hash = 1;
    for (size_t k = 0; k < sizeof all; k++)
        hash = (hash ^ bytes[k]) * 0x100000001b3u;
    printf("%llx\n", hash);
}

static void fill(void) {
    for (int i = 0; i < N + BEYOND; i++) {
        x[i] = 1 + (i * 37 % 1009) * 0.01;
        key[i] = i * 7919 % ROWS;
    }
    for (int k = 0; k < ROWS + 2 * N + BEYOND; k++)
        all[k] = k % 7;
}

static int pairs(double *restrict h, int first, int n) {
    int last = -1;
    for (int i = first; i < n; i++) { // EXPECT: transformed
        for (int j = 0; j < M; j++)
            h[(int)(sqrt(x[i]) * sqrt(x[j]) * 20)] += x[j] * (i + 1);
        last = key[i];
    }
    return last;
}

/* The loop may update its bound and its reads. */
static void overlapping(double *h, const double *f, const int *k, int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double s = f[i] * 1e-3;
        for (int j = 0; j < M; j++)
            s += sqrt(fabs(s) + j) * 1e-3;
        h[k[i]] += s;
        h[k[i] + 1] -= s;
    }
}

/* As above, for arrays that overlap in the first execution. */
static void reads_what_it_updates(double *h, const double *f, const int *k, int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double s = f[i] * 1e-3;
        for (int j = 0; j < M; j++)
            s += sqrt(fabs(s) + j) * 1e-3;
        h[k[i]] += s;
        h[k[i] + 1] -= s;
    }
}

/* Few iterations. */
static int few(double *restrict h, int n) {
    int last = -1;
    for (int i = 3; i < n; i++) { // EXPECT: transformed
        double s = i;
        for (int j = 0; j < 50; j++)
            s += sqrt(s + j) * 1e-3;
        h[key[i]] += s;
        last = key[i] + i;
    }
    return last;
}

/* Results depend on each iteration's number. */
static long numbered(double *restrict h, int n) {
    int at = 5;
    for (int i = 0; i < n; i++, at += 3) { // EXPECT: transformed
        double s = at;
        for (int j = 0; j < M; j++)
            s += sqrt(fabs(s) + j) * 1e-3;
        h[key[i] + at % 3] += s;
    }
    return at;
}

static int leaves(double *restrict h, int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        double s = i;
        if (key[i] == 77)
            return i;
        for (int j = 0; j < M; j++)
            s += sqrt(fabs(s) + j) * 1e-3;
        h[key[i]] += s;
    }
    return -1;
}

int main(void) {
    fill();
    printf("%d\n", pairs(all, 17, N));
    print(all);
    overlapping(all, all + ROWS + N, key, N);
    print(all);
    reads_what_it_updates(all, all + ROWS / 2, key, N);
    print(all);
    printf("%d\n", few(all, 500));
    print(all);
    printf("%ld\n", numbered(all, N));
    print(all);
    printf("%d\n", leaves(all, N));
    print(all);
    return 0;
}
