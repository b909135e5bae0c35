/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "fuzz.h"

#include <fenv.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

static int is_integral = -1;
static uint64_t state;
static _Thread_local double level;

static unsigned any(void) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(state >> 33);
}

int fuzz_runs(unsigned long long seed) {
    const char *list = getenv("FUZZ_LEFT_OUT");
    while (list && *list) {
        char *end;
        if (strtoull(list, &end, 10) == seed)
            return 0;
        list = *end ? end + 1 : end;
    }
    return 1;
}

void fuzz_seed(unsigned long long seed) {
    state = seed;
    is_integral = getenv("FUZZ_INTEGERS") != NULL;
    level = 1.0 / (double)(seed % 7 + 2);
    if (is_integral)
        level = 3;
    if (getenv("FUZZ_DOWNWARD"))
        fesetround(seed % 2 ? FE_DOWNWARD : FE_UPWARD);
}

/* The section ends with an object of this file, which may share its last page with other data. */
FUZZ_HELD __attribute__((used)) char last_held = 1;
extern char __start_fuzz_held[], __stop_fuzz_held[];

void fuzz_hold(int is_held) {
    const size_t size = (size_t)(__stop_fuzz_held - __start_fuzz_held) / 4096 * 4096;
    if (size && mprotect(__start_fuzz_held, size, is_held ? PROT_READ : PROT_READ | PROT_WRITE))
        abort();
}

void fuzz_fail(void) {
    abort();
}

double fuzz_level(int i) {
    return level * i;
}

double fuzz_scaled(double v) {
    return level * v;
}

int fuzz_below(int n) {
    return (int)(any() % (unsigned)n);
}

/* Returns a random value that uses all bits of a double, over several binades. If is_integral,
 * returns an integer in -4 ... 4. */
static double value(void) {
    if (is_integral)
        return fuzz_below(9) - 4;
    const double high = (double)any() * 0x1p-30 - 1.0;
    const double v = high + (double)any() * 0x1p-60;
    return fuzz_below(4) == 0 ? v * 0x1p-20 : v;
}

static void set_integer(void *to, size_t bytes, int v) {
    const int64_t wide = v;
    memcpy(to, &wide, bytes); /* the low bytes */
}

static void set(void *to, enum fuzz_type type, int below) {
    switch (type) {
    case FUZZ_DOUBLE:
        *(double *)to = value();
        break;
    case FUZZ_FLOAT:
        *(float *)to = (float)value();
        break;
    case FUZZ_LONG_DOUBLE:
        *(long double *)to = value();
        break;
    case FUZZ_COMPLEX:
        ((double *)to)[0] = value();
        ((double *)to)[1] = value();
        break;
    default:
        set_integer(to, (size_t)1 << (type - FUZZ_INT8), fuzz_below(below));
        break;
    }
}

void fuzz_fill(void *to, int count, size_t step, enum fuzz_type type, int below) {
    for (int i = 0; i < count; i++)
        set((char *)to + (size_t)i * step, type, below);
}

void fuzz_fill_chain(int *to, int count, int below) {
    for (int i = 0; i < count; i++)
        to[i] = i && i < below ? fuzz_below(i) / 2 : 0;
}

void fuzz_fill_first(int *to, int count, int mask) {
    to[0] = 0;
    for (int i = 1; i < count; i++)
        to[i] = to[i - 1] + (i & mask) % 3;
}

void fuzz_fill_far(int *to, int count, int below) {
    for (int i = 0; i < count; i++)
        to[i] = fuzz_below(8) ? fuzz_below(below) : 1 << 30;
}

void fuzz_print(const char *name, const void *bytes, size_t size) {
    const unsigned char *b = bytes;
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i + 8 <= size; i += 8) {
        uint64_t word;
        memcpy(&word, b + i, 8);
        hash = (hash ^ word) * 0x100000001b3u;
        hash ^= hash >> 29;
    }
    for (size_t i = size / 8 * 8; i < size; i++)
        hash = (hash ^ b[i]) * 0x100000001b3u;
    printf("%s %016llx\n", name, (unsigned long long)hash);
}

void fuzz_print_ordered(const char *name, const void *bytes, size_t size) {
    if (!is_integral)
        fuzz_print(name, bytes, size);
}
