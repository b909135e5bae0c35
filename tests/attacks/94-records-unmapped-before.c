/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// THREADS: 1 2 7
// METHODS: auto localwrite
// The program dereferences a pointer before the loop, then unmaps its target. No iteration dereferences it,
// so code that is evaluated before the first iteration must not do so either.
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>

enum { N = 5000, M = 100 };
struct table {
    double scale;
    double *h;
};
static int s[N];
static double h[M];

static void add(struct table *p, int n, int limit) {
    const double scale = p->scale;
    if (limit >= M)
        munmap(p, sizeof *p);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (s[t] >= limit)
            p->h[s[t]] += scale * t;
}

int main(void) {
    struct table *p = mmap(NULL, sizeof *p, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (p == MAP_FAILED)
        return 1;
    *p = (struct table){0.3, h};
    for (int t = 0; t < N; t++)
        s[t] = t * 37 % M;
    for (int k = 0; k < 5; k++)
        add(p, N, k);
    add(p, N, M);
    double sum = 0;
    for (int k = 0; k < M; k++)
        sum += h[k] * k;
    printf("%a\n", sum);
    return 0;
}
