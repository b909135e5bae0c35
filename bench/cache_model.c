/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Computes table 1 of the paper (docs/paper.md): the cache miss rate of the final stage of array
 * expansion (figure 9). This stage adds each thread's copy of the array to the array,
 *
 *     (a)  for each element: for each copy: b[i] += copy[t][i]
 *     (b)  for each copy: for each element: b[i] += copy[t][i]
 *
 * for one thread's share of the elements and 1 to 32 copies. The model is a set-associative cache
 * with lines of 64 bytes, 4 ways, LRU replacement and 32 KiB. `apart` is the distance between
 * copies. It is either a power of two, with which the lines of all copies fall into one set, or the
 * size of the paper's mesh of 218272 nodes with 3 doubles each, padded to lines.
 *
 * Prints lines: apart,threads,a_percent,b_percent.
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { LINE = 64, WAYS = 4, SETS = 32768 / LINE / WAYS, ELEMENTS = 8192 };

static uint64_t tag[SETS][WAYS]; /* most recently used first; 0: an empty line */
static long accesses, misses;

static void clear(void) {
    memset(tag, 0, sizeof tag);
    accesses = misses = 0;
}

static void access_to(uint64_t address) {
    const uint64_t line = address / LINE + 1;
    uint64_t *set = tag[line % SETS];
    int way = 0;
    while (way < WAYS - 1 && set[way] != line)
        way++;
    misses += set[way] != line;
    accesses++;
    memmove(set + 1, set, (size_t)way * sizeof *set);
    set[0] = line;
}

/* Simulates b[i] += copy[t][i]; the copies follow the array in memory. */
static void add(uint64_t apart, int t, int i) {
    const uint64_t b = (uint64_t)i * sizeof(double);
    access_to(b);
    access_to(b + (uint64_t)(t + 1) * apart);
    access_to(b);
}

static double percent(void) {
    return 100.0 * (double)misses / (double)accesses;
}

static void print_row(const char *name, uint64_t apart, int threads) {
    const int share = ELEMENTS; /* elements per thread; all threads have the same miss rate */
    clear();
    for (int i = 0; i < share; i++)
        for (int t = 0; t < threads; t++)
            add(apart, t, i);
    const double a = percent();
    clear();
    for (int t = 0; t < threads; t++)
        for (int i = 0; i < share; i++)
            add(apart, t, i);
    printf("%s,%d,%.2f,%.2f\n", name, threads, a, percent());
}

int main(void) {
    const uint64_t bytes = 218272 * 3 * sizeof(double);
    puts("apart,threads,a_percent,b_percent");
    for (int threads = 1; threads <= 32; threads *= 2)
        print_row("a power of two", 1u << 23, threads);
    for (int threads = 1; threads <= 32; threads *= 2)
        print_row("the mesh", (bytes + LINE - 1) / LINE * LINE, threads);
    return 0;
}
