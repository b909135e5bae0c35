/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Access rights by protection keys belong to a thread (pkeys(7)). Threads start while the table must
 * not be read. Then it is opened, closed for writing, and closed again. Without keys in the processor
 * or system the loops run on ordinary memory. */
// THREADS: 2 3 7 33
#define _GNU_SOURCE
#include <stdio.h>
#include <sys/mman.h>

enum { N = 30000, K = 1024 };
static int k[N];
static double h[K];

__attribute__((noinline)) static void plain(void) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += 1.0 / (1 + t);
}

__attribute__((noinline)) static void reads(const double *x) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += x[t % K] / (2 + t);
}

__attribute__((noinline)) static void updates(double *x) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        x[k[t]] += 1.0 / (3 + t);
}

int main(void) {
    double *const x = mmap(NULL, K * sizeof *x, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    for (int t = 0; t < N; t++)
        k[t] = (int)(t * 7919LL % K);
    for (int i = 0; i < K; i++)
        x[i] = i;
    const int key = pkey_alloc(0, PKEY_DISABLE_ACCESS);
    if (key >= 0 && pkey_mprotect(x, K * sizeof *x, PROT_READ | PROT_WRITE, key) != 0)
        return 1;
    for (int round = 0; round < 6; round++) {
        plain();
        if (key >= 0)
            pkey_set(key, PKEY_DISABLE_WRITE);
        reads(x);
        if (key >= 0)
            pkey_set(key, 0);
        updates(x);
        if (key >= 0)
            pkey_set(key, PKEY_DISABLE_ACCESS);
    }
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.9 + h[i];
    printf("%a\n", sum);
    return 0;
}
