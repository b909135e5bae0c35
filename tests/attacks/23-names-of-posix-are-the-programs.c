/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* ISO C leaves the names of POSIX to the program (C17 7.1.3), so the program may define functions with these names. */
// CFLAGS: -O2 -std=c11
// METHODS: auto localwrite graph-localwrite
#include <stdio.h>
#include <stdlib.h>

static long called;
#define MINE(name)                                                                                 \
    long name(long a) {                                                                            \
        called++;                                                                                  \
        return -a;                                                                                 \
    }
MINE(read) MINE(close) MINE(open) MINE(access) MINE(fcntl) MINE(sched_yield) MINE(mmap)
MINE(munmap) MINE(mremap) MINE(madvise) MINE(ioctl) MINE(opendir) MINE(readdir) MINE(closedir)
MINE(dirfd) MINE(clock_gettime) MINE(sched_getaffinity) MINE(getcpu) MINE(getpid) MINE(fstat)
MINE(stat) MINE(getrlimit) MINE(readlinkat) MINE(nanosleep) MINE(strtok_of_mine)

enum { N = 300000, K = 5000 };
static int k[N];
static double h[K];

static void fill(void) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += 1.0 / (1 + t);
}

int main(void) {
    for (int t = 0; t < N; t++)
        k[t] = (int)((t * 7919LL + t / 3) % K);
    for (int round = 0; round < 60; round++) /* long enough for the runtime to track writes to the subscripts */
        fill();
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a %ld %ld %ld\n", sum, called, mmap(3), read(4));
    return 0;
}
