/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A look-up examines up to four elements and stops at the first match. The object, and the readable
// memory, may end there, so a comparison of contents must not read further.
#define _GNU_SOURCE
#include <stdio.h>
#include <sys/mman.h>
#include <unistd.h>

enum { N = 4000 };

#define KEEP __attribute__((noipa)) static

static int returned(const int *a) {
    for (int c = 0; c < 4; c++)
        if (a[c] == 0)
            return c;
    return 4;
}

static int left(const int *a) {
    int found = 4;
    for (int c = 0; c < 4; c++) {
        if (a[c] == 0) {
            found = c;
            break;
        }
    }
    return found;
}

static int summed(const int *a) {
    int sum = 0;
    for (int c = 0; c < 4; c++)
        sum += a[c];
    return sum & 7;
}

KEEP void by_return(int n, const int *a, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t] + returned(a)] += t + 0.5;
}

KEEP void by_break(int n, const int *a, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t] + left(a)] += t + 0.5;
}

KEEP void moving(int n, const int *a, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t] + returned(a + t)] += t + 0.5;
}

KEEP void all(int n, const int *a, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t] + summed(a)] += t + 0.5;
}

int main(void) {
    static double h[N + 8];
    static int k[N];
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    const size_t size = (sizeof(int) * N / page + 2) * page;
    char *memory = mmap(NULL, size + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED || mprotect(memory + size, page, PROT_NONE) != 0)
        return 1;
    int *end = (int *)(memory + size); /* all elements before it are 0 */
    for (int i = 0; i < N; i++)
        k[i] = (int)(i * 2654435761u % N);
    for (int r = 0; r < 4; r++) {
        by_return(N, end - 1, k, h);
        by_break(N, end - 1, k, h);
        moving(N, end - N, k, h);
        all(N, end - 4, k, h);
    }
    double sum = 0;
    for (int i = 0; i < N; i++)
        sum += h[i] * (i % 7);
    printf("%a\n", sum);
    return 0;
}
