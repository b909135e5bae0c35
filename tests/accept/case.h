/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Shared by the programs of tests/accept: input values from a fixed generator, and hashes of all the bytes that a
 * program computed. CASE_INTEGERS=1 in the environment makes all values small integers, whose sums do not depend on the
 * order of the additions.
 */
#ifndef CASE_H
#define CASE_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static inline uint64_t case_random(void) {
    static uint64_t state = 0x9e3779b97f4a7c15u;
    uint64_t z = (state += 0x9e3779b97f4a7c15u); /* splitmix64 */
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static inline int case_below(int n) {
    return (int)(case_random() % (uint64_t)n);
}

/* Returns a value in (-1, 1) with all bits of a double in use; with CASE_INTEGERS, an integer in -4 ... 4. */
static inline double case_value(void) {
    static int is_integer = -1;
    if (is_integer < 0)
        is_integer = getenv("CASE_INTEGERS") != NULL;
    if (is_integer)
        return (double)(case_below(9) - 4);
    const double v = (double)(int64_t)(case_random() >> 11) * 0x1p-52 - 1.0;
    return case_below(4) == 0 ? v * 0x1p-20 : v;
}

static inline void case_values(double *v, long n) {
    for (long i = 0; i < n; i++)
        v[i] = case_value();
}

static inline void case_subscripts(int *s, long n, int below) {
    for (long i = 0; i < n; i++)
        s[i] = case_below(below);
}

/* Sets subscripts mostly near i * below / n, as in a sorted mesh. */
static inline void case_near_subscripts(int *s, long n, int below) {
    for (long i = 0; i < n; i++) {
        const long near = i * below / n + case_below(40) - 20;
        s[i] = (int)(near < 0 ? 0 : near >= below ? below - 1 : near);
    }
}

static inline void case_print(const char *name, const void *bytes, size_t size) {
    const unsigned char *b = bytes;
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ b[i]) * 0x100000001b3u;
    printf("%s %016llx\n", name, (unsigned long long)hash);
}

#define CASE_PRINT(array) case_print(#array, (array), sizeof(array))

#endif
