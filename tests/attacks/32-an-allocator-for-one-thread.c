/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The program replaces malloc (as glibc permits) by an allocator that is safe for one thread only. */
#define _GNU_SOURCE
#include <errno.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

#ifndef SIZE
#define SIZE 60000
#define AREA (64 << 20)
#endif

static char area[AREA] __attribute__((aligned(64)));
static size_t used;
static volatile long elsewhere;

void *malloc(size_t bytes) {
    elsewhere += syscall(SYS_gettid) != getpid();
    size_t *block = (size_t *)(area + used);
    used += (bytes + 64 + 63) / 64 * 64;
    if (used > sizeof area)
        return NULL;
    block[0] = bytes;
    return (char *)block + 64;
}
void free(void *block) {
    elsewhere += block && syscall(SYS_gettid) != getpid();
    if (block && ((char *)block < area || (char *)block >= area + sizeof area))
        _exit(77); /* not from this allocator */
}
void *calloc(size_t count, size_t bytes) {
    return malloc(count * bytes); /* zero already, since memory is never reused */
}
#ifndef WITHOUT_ALIGNED /* 46-an-allocator-without-aligned-memory.c */
void *aligned_alloc(size_t alignment, size_t bytes) {
    return alignment <= 64 ? malloc(bytes) : NULL;
}
void *memalign(size_t alignment, size_t bytes) {
    return aligned_alloc(alignment, bytes);
}
int posix_memalign(void **block, size_t alignment, size_t bytes) {
    *block = aligned_alloc(alignment, bytes);
    return *block ? 0 : ENOMEM;
}
#endif
void *realloc(void *block, size_t bytes) {
    void *other = malloc(bytes);
    if (other && block)
        memcpy(other, block, bytes < ((size_t *)((char *)block - 64))[0]
                                 ? bytes
                                 : ((size_t *)((char *)block - 64))[0]);
    return other;
}

enum { N = SIZE, K = 700 };
static int k[N];
static double h[K];

__attribute__((noinline)) static void fill(void) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += 1.0 / (1 + t);
}

int main(void) {
    for (int round = 0; round < 30; round++) {
        for (int t = 0; t < N; t++)
            k[t] = (int)((t * (7919LL + round / 4) + t / 3) % K);
        fill();
    }
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a, %ld allocations in other threads\n", sum, elsewhere);
    return 0;
}
