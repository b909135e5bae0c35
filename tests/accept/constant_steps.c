/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Inner loops with constant bounds whose step skips elements: the last value of the counter is the
 * last one that it takes, not the last one below the bound. Lists and vectors end at the end of
 * their memory, so that any other read is a crash. */
#define _GNU_SOURCE
#include <sys/mman.h>

#include "case.h"

enum { N = 20000, ROWS = 64, SHORT = 8, FAR = 1 << 14 };

static double sum[ROWS], weight[N];
static int *list, *low, *apart;
static double (*vector)[SHORT];

static void upwards(const int *k, const double *w, double *b, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 14; c += 7)
            b[(k[c] + t) % ROWS] += w[t] * c + 1;
}

static void downwards(const int *k, const double *w, double *b, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 7; c > -6; c -= 7)
            b[(k[c] + t) % ROWS] += w[t] * c + 1;
}

static void unequal(const int *k, const double *w, double *b, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 1; c != 10; c += 3)
            b[(k[c] + t) % ROWS] += w[t] * c + 1;
}

static int second(const int *k) {
    int s = 0;
    for (int c = 0; c <= 13; c += 7)
        s += k[c];
    return s;
}

static void by_call(const int *k, const double *w, double *b, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[(second(k) + t) % ROWS] += w[t];
}

/* The elements between those that are read are not mapped. */
static void far_apart(const int *k, const double *w, double *b, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 32769; c += 32768)
            b[(k[c] + t) % ROWS] += w[t] + c;
}

static void vectors(int n, const int (*pair)[2], double (*v)[SHORT]) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 14; c += 7)
            v[pair[t][0]][c] += weight[t];
        for (int c = 7; c > -6; c -= 7)
            v[pair[t][1]][c] -= weight[t];
    }
}

/* Memory whose neighbours before and after are not mapped. */
static char *lonely(size_t page) {
    char *all = mmap(NULL, 3 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    munmap(all, page);
    munmap(all + 2 * page, page);
    return all + page;
}

int main(void) {
    static int pair[N][2];
    const size_t page = FAR * sizeof *list;
    apart = mmap(NULL, 3 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    munmap(apart + FAR, page);
    apart[0] = 3, apart[2 * FAR] = 5;
    list = (int *)(void *)(lonely(page) + page) - SHORT;
    low = (int *)(void *)lonely(page);
    vector = (double (*)[SHORT])(void *)(lonely(page) + page) - ROWS;
    case_values(weight, N);
    for (int i = 0; i < SHORT; i++)
        list[i] = 3 * i + 1, low[i] = 5 * i;
    for (int t = 0; t < N; t++) {
        pair[t][0] = t % 7 ? t % ROWS : ROWS - 1;
        pair[t][1] = t % 5 ? (3 * t + 1) % ROWS : 0;
    }
    for (int repeat = 0; repeat < 6; repeat++) {
        upwards(list, weight, sum, N);
        downwards(list, weight, sum, N);
        downwards(low, weight, sum, N);
        unequal(list, weight, sum, N);
        far_apart(apart, weight, sum, N);
        by_call(list, weight, sum, N);
        vectors(N, (const int (*)[2])pair, vector);
    }
    case_print("sum", sum, sizeof sum);
    case_print("vector", vector, ROWS * sizeof *vector);
    return 0;
}
