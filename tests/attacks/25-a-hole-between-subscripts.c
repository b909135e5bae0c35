/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Subscripts k[pos[t]] lie on both sides of pages that must not be read (POSIX). A second call looks
 * for the plan again, and a third changes all subscripts. */
// METHODS: auto localwrite
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>

enum { N = 40000, H = 3000, AREA = 1 << 20 };
static int pos[N];
static double h[H];

__attribute__((noinline)) static void through(const int *k) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[pos[t]]] += 1.0 / (1 + t);
}

__attribute__((noinline)) static void plain(const int *k) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += 1.0 / (2 + t);
}

int main(void) {
    int *k = mmap(NULL, 3 * AREA, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    const int far = 2 * AREA / (int)sizeof *k;
    for (int t = 0; t < N; t++) {
        k[t] = (int)(t * 7LL % H);
        k[far + t] = (int)(t * 11LL % H);
        pos[t] = t % 2 ? t : far + t;
    }
    if (mprotect((char *)k + AREA, AREA, PROT_NONE) != 0)
        return 1;
    for (int round = 0; round < 5; round++) {
        through(k);
        plain(k);
        if (round > 2)
            k[far + 2 * round] = (k[far + 2 * round] + 1) % H;
    }
    for (int round = 0; round < 4; round++) { /* in the first two rounds these pages may be read */
        mprotect((char *)k + AREA, AREA, round > 1 ? PROT_NONE : PROT_READ);
        through(k);
    }
    double sum = 0;
    for (int i = 0; i < H; i++)
        sum = sum * 0.5 + h[i];
    printf("%a\n", sum);
    return 0;
}
