/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -O2 -fopenmp -std=gnu89
// METHODS: auto localwrite binning
/* Clauses on variables declared before the loop, as C89 requires. */
#include <stdio.h>

enum { N = 5000, K = 60 };
static int k[N];
static double h[K], v[N];
struct item { double x; int y; };

static double calls(int n, const int by) {
    struct item item = {0.5, 3};
    int t = -1, step = 2, i;
    double x = 7, last = 1, sum = 0;
#pragma omp parallel for private(x, i) firstprivate(step, item, by) lastprivate(last) \
    reduction(+ : h, sum) if (n > 2 && item.y == 3) schedule(static, 5)
    for (t = 0; t < n; t++) { // EXPECT: parallel
        x = v[t] * by + item.x;
        for (i = 0; i < step; i++)
            h[k[t]] += x;
        last = x * 2;
        sum += x;
    }
    if (t != -1 || x != 7 || step != 2 || item.x != 0.5 || by != 2)
        printf("a private variable's original has changed\n");
    return last + sum;
}

static double counter_wanted(int n) {
    int t = 0;
    double x = 0;
#pragma omp parallel for lastprivate(t)
    for (t = 0; t < n; t++) { // EXPECT: parallel
#pragma omp atomic
        h[k[t]] += v[t];
    }
    x = t;
    return x;
}

int main(void) {
    int t, round;
    double all = 0;
    for (t = 0; t < N; t++) {
        k[t] = t * 7919 % K;
        v[t] = t % 16;
    }
    for (round = 0; round < 4; round++) {
        all += calls(round == 2 ? 2 : N, 2);
        all += counter_wanted(N);
    }
    for (t = 0; t < K; t++)
        printf("%a\n", h[t]);
    printf("%a\n", all);
    return 0;
}
