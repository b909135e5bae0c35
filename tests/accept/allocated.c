/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Pointers to the arrays are function results, converted from void * to the arrays' type.
// MAY-RUN-SERIALLY: one loop reads the array that it updates
// covers: row 50 of docs/constructs.md
#include "case.h"

enum { N = 9000, M = 500 };
static int s[N];
static double e[N];

static double *kept;

static __attribute__((noinline)) void *same(void *p) {
    kept = p;
    return p;
}

static void allocated(int n) {
    double *h = (double *)calloc(M, sizeof(double));
    char *bytes = (char *)(void *)malloc(M);
    float *later;
    later = (float *)calloc(M, sizeof *later);
    if (!h || !bytes || !later)
        return;
    for (int i = 0; i < M; i++)
        bytes[i] = 0;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += e[t];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        bytes[s[t]]++;
        later[s[t]] += (float)e[t] * t;
    }
    case_print("h", h, M * sizeof *h);
    case_print("bytes", bytes, M);
    case_print("later", later, M * sizeof *later);
    free(h);
    free(bytes);
    free(later);
}

/* `same` returns its argument, so `h`, `local` and `kept` are one array. */
static void given_back(int n) {
    double local[M];
    case_values(local, M);
    double *h = (double *)same(local);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += local[t % M] * 0.5 + kept[0];
    CASE_PRINT(local);
}

int main(void) {
    case_subscripts(s, N, M);
    case_values(e, N);
    for (int round = 0; round < 2; round++) {
        allocated(N);
        given_back(N);
    }
    return 0;
}
