/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A search in a row always finds its element, and readable memory ends with the page of the last element
 * read. The row's end is further on. The inspector records the whole row's extent, but it must read only
 * elements that the program reads. covers: row 80 of docs/constructs.md */
#define _DEFAULT_SOURCE
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { N = 20000, ROWS = 64 };
static int ptr[ROWS + 1], row[N], wanted[N];
static double v[N], h[4096], positions[4096];

static int find(const int *ptr, const int *col, int i, int j) {
    for (int k = ptr[i]; k < ptr[i + 1]; k++)
        if (col[k] == j)
            return k;
    return -1;
}

static double first_below(const double *x, const int *count, double limit) {
    if (count)
        for (int k = 0; k < *count; k++)
            if (x[k] < limit)
                return x[k];
    return 0;
}

__attribute__((noinline)) static void scatter(int n, const int *ptr, const int *col, double *a) {
    for (int e = 0; e < n; e++) { // EXPECT: transformed
        int k = find(ptr, col, row[e], wanted[e]);
        if (k >= 0)
            a[k] += v[e];
    }
}

/* In some calls `count` has null pointers, and then no iteration reads the bounds. */
__attribute__((noinline)) static void limited(int n, const int *const *count, const double *x,
                                              double *a) {
    for (int e = 0; e < n; e++) // EXPECT: refuse callee-reads
        a[wanted[e]] += first_below(x, count[e], v[e]);
}

/* For comparison: this function reads all of each row. */
static double sum_of(const int *ptr, const int *col, const double *x, int i) {
    double sum = 0;
    for (int k = ptr[i]; k < ptr[i + 1]; k++)
        sum += x[col[k]];
    return sum;
}

__attribute__((noinline)) static void gather(int n, const int *ptr, const int *col, const double *x,
                                             double *a) {
    for (int e = 0; e < n; e++) // EXPECT: parallel
        a[wanted[e]] += sum_of(ptr, col, x, row[e]);
}

int main(void) {
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    char *mapped = mmap(NULL, 3 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED || mprotect(mapped + 2 * page, page, PROT_NONE))
        return 1;
    const int length = (int)(2 * page / sizeof(int)), each = length / ROWS;
    int *col = (int *)mapped;
    for (int k = 0; k < length; k++)
        col[k] = k % each;
    for (int r = 0; r <= ROWS; r++)
        ptr[r] = r * each;
    for (int r = 0; r < 4096; r++)
        positions[r] = 1.0 / (r + 3);
    for (int e = 0; e < N; e++) {
        row[e] = (int)((unsigned)e * 2654435761u >> 7) % ROWS;
        wanted[e] = (int)((unsigned)e * 40503u >> 3) % each;
        v[e] = 1.0 / (e % 97 + 1);
    }
    static const int *counts[N];
    int few = 3;
    for (int e = 0; e < N; e++)
        counts[e] = e % 3 ? &few : NULL;
    for (int round = 0; round < 6; round++) {
        ptr[ROWS] = length + (round & 1 ? 3000 : 0); /* the search ends before the further elements */
        scatter(N, ptr, col, h);
        col[(round * 7 + 1) * each + 5] = 7; /* twice in that row: the search finds the first */
        limited(N, counts, positions, h);
    }
    ptr[ROWS] = length;
    gather(N, ptr, col, positions, h);
    unsigned long long hash = 1469598103934665603u;
    for (size_t i = 0; i < sizeof h; i++)
        hash = (hash ^ ((unsigned char *)h)[i]) * 1099511628211u;
    printf("%llx\n", hash);
    return 0;
}
