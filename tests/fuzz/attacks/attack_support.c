/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE
#include "attack_support.h"

#include <locale.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

static uint64_t state, noted;

static unsigned any(void) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(state >> 33);
}

void attack_seed(unsigned long long seed) {
    state = seed;
    noted = 0;
}

int attack_below(int n) {
    return n > 0 ? (int)(any() % (unsigned)n) : 0;
}

static double value(void) {
    return (double)any() * 0x1p-30 - 1.0 + (double)any() * 0x1p-60;
}

void attack_fill(void *to, int count, size_t size, int is_floating) {
    for (int i = 0; i < count; i++) {
        const double v = value();
        const float narrow = (float)v;
        const uint64_t whole = (uint64_t)(v * v * 60);
        const void *from = is_floating == 8 ? (const void *)&v
                           : is_floating    ? (const void *)&narrow
                                            : &whole;
        memcpy((char *)to + (size_t)i * size, from, size);
    }
}

void attack_fill_ints(int *to, int count, int below) {
    for (int i = 0; i < count; i++)
        to[i] = attack_below(below);
}

void attack_fill_doubles(double *to, int count) {
    for (int i = 0; i < count; i++)
        to[i] = value();
}

static uint64_t mix(uint64_t hash, uint64_t word) {
    hash = (hash ^ word) * 0x100000001b3u;
    return hash ^ hash >> 29;
}

void attack_note(double v) {
    uint64_t word;
    memcpy(&word, &v, 8);
    noted = mix(noted, v == v ? word : 1);
}

void attack_print(unsigned seed, const void *bytes, size_t size, int is_floating) {
    const size_t step = is_floating ? (size_t)is_floating : 8;
    uint64_t hash = noted;
    for (size_t i = 0; i < size; i += step) {
        uint64_t word = 0;
        double v = 0;
        float narrow = 0;
        memcpy(&word, (const char *)bytes + i, size - i < step ? size - i : step);
        memcpy(&v, &word, 8);
        memcpy(&narrow, &word, 4);
        if ((is_floating == 8 && v != v) || (is_floating == 4 && narrow != narrow))
            word = 1;
        hash = mix(hash, word);
    }
    printf("%u %016llx\n", seed, (unsigned long long)hash);
    fflush(stdout);
}

/* ---- functions of another file that read more than their arguments --------------------------- */

static const unsigned char *watched;
static size_t watched_count = 1;

void attack_watch(const void *bytes, size_t count) {
    watched = bytes;
    watched_count = count;
}

int attack_watched(int i) {
    return watched[(size_t)(unsigned)i * 7 % watched_count];
}
int parity(int i) {
    return attack_watched(i);
}
int expect(int i) {
    return attack_watched(i);
}
int clz(int i) {
    return attack_watched(i);
}
int popcount(int i) {
    return attack_watched(i);
}
int ctzl(int i) {
    return attack_watched(i);
}
double absf(double v) {
    return attack_watched((int)v);
}
double inf(int i) {
    return attack_watched(i);
}
double huge_val(int i) {
    return attack_watched(i);
}
int isinf_sign(int i) {
    return attack_watched(i);
}
int parityl(int i) {
    return attack_watched(i);
}
double expectf(double v) {
    return attack_watched((int)v);
}

/* ---- values that belong to a thread ---------------------------------------------------------- */

static _Thread_local int own[256];
static _Thread_local int number;

const int *attack_table(void) {
    return own;
}
int attack_thread_value(int i) {
    return number + i;
}
int attack_thread_number(void) {
    return number;
}
void attack_set_thread(int v) {
    number = v;
    for (int i = 0; i < 256; i++)
        own[i] = v ? (i * 37 + v) % 251 : 0;
}

void attack_set_locale(void) {
    static locale_t other;
    const char *name = getenv("ATTACK_LOCALE");
    if (name && !other)
        other = newlocale(LC_CTYPE_MASK, name, NULL);
    if (other)
        uselocale(other);
}

void attack_reset_locale(void) {
    uselocale(LC_GLOBAL_LOCALE);
}

void *attack_same(const void *p) {
    return (void *)(uintptr_t)p;
}

void attack_mark(const void **entries, int count, const void *mark) {
    for (int i = 0; i < count; i++)
        entries[i] = attack_below(3) ? NULL : mark;
}

/* ---- memory at two addresses ----------------------------------------------------------------- */

static void *map_at(void *at, size_t bytes, int flags, int file, size_t offset) {
    void *const place =
        mmap(at, bytes, PROT_READ | PROT_WRITE, flags | (at ? MAP_FIXED : 0), file, (off_t)offset);
    if (place == MAP_FAILED)
        abort();
    return place;
}

void attack_map(unsigned long *both[2], int kind) {
    const size_t bytes = 1024 * sizeof **both;
    const int file = memfd_create("attack", 0);
    if (file < 0 || ftruncate(file, (off_t)(2 * bytes)) != 0)
        abort();
    if (!both[0]) {
        both[0] = map_at(NULL, 4 * bytes, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        both[1] = both[0] + (kind == 2 ? 1 : 2) * 1024;
    }
    map_at(both[0], bytes, MAP_SHARED, file, 0);
    map_at(both[1], bytes, kind == 3 ? MAP_PRIVATE : MAP_SHARED, file, kind == 0 ? bytes : 0);
    close(file);
}

/* The section's last object: nothing else lies in its page. */
ATTACK_PAGE char attack_last_page[4096];
extern char __start_attack_pages[], __stop_attack_pages[];

void attack_hold(void) {
    if (mprotect(__start_attack_pages, (size_t)(__stop_attack_pages - __start_attack_pages),
                 PROT_READ) != 0)
        abort();
}
