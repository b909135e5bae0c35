/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Plans are kept for two disjoint arrays. Then both are mapped to one memory object, at their
 * addresses, and to two again (POSIX). */
// METHODS: auto binning localwrite localwrite-steal graph-localwrite wavefront
// THREADS: 1 2 3 16
#define _GNU_SOURCE
#include <stdio.h>
#include <sys/mman.h>
#include <unistd.h>

enum { N = 20000, H = 8192, BYTES = H * (int)sizeof(double) };
static int k[N], m[N];

__attribute__((noinline)) static void updates(double *a, double *b) {
    for (int t = 0; t < N; t++) { // EXPECT: parallel
        a[k[t]] += 1.0 / (1 + t);
        b[m[t]] *= 0.999;
    }
}

__attribute__((noinline)) static void reads(double *a, const double *b) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        a[k[t]] += 1e-6 * b[m[t]];
}

static void rounds(double *a, double *b, int count) {
    for (int round = 0; round < count; round++) {
        updates(a, b);
        reads(a, b);
    }
    double sum = 0;
    for (int i = 0; i < H; i++)
        sum = sum * 0.999 + a[i] - b[i];
    printf("%a\n", sum);
}

int main(void) {
    for (int t = 0; t < N; t++) {
        k[t] = (int)(t * 7919LL % 97);
        m[t] = 60 + (int)(t * 104729LL % 89);
    }
    const int file = memfd_create("later", 0);
    if (file < 0 || ftruncate(file, 2 * BYTES) != 0)
        return 1;
    double *const a = mmap(NULL, 2 * BYTES, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    double *const b = a + H;
    for (int turn = 0; turn < 2; turn++) {
        rounds(a, b, 5);
        if (mmap(b, BYTES, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, file, 0) != b)
            return 1;
        rounds(a, b, 3);
        if (mmap(b, BYTES, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, file, BYTES) != b)
            return 1;
    }
    rounds(a, b, 2);
    return 0;
}
