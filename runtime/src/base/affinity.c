/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/affinity.h"

#include "base/system.h"

#if defined(__linux__)

enum { WORD_BITS = 8 * sizeof(unsigned long) };

static long words_of(const struct processors *these) {
    return these->bytes / (long)sizeof *these->word;
}

struct processors redcc_processors_of(long thread) {
    struct processors all = {.bytes = 0};
    const long bytes = redcc_system(SYS_sched_getaffinity, thread, sizeof all.word, all.word);
    all.bytes = bytes > 0 ? bytes : 0;
    return all;
}

struct processors redcc_processors_without(struct processors these, const unsigned long *taken,
                                           size_t words) {
    unsigned long any = 0;
    for (long word = 0; word < words_of(&these); word++) {
        these.word[word] &= ~((size_t)word < words ? taken[word] : 0);
        any |= these.word[word];
    }
    these.bytes = any ? these.bytes : 0;
    return these;
}

struct processors redcc_processors_only(struct processors these, int core) {
    struct processors one = {.bytes = these.bytes};
    const int word = core / WORD_BITS;
    if (core < 0 || word >= words_of(&these))
        return (struct processors){.bytes = 0};
    one.word[word] = these.word[word] & 1ul << core % WORD_BITS;
    one.bytes = one.word[word] ? one.bytes : 0;
    return one;
}

static bool place(long thread, const struct processors *where) {
    return redcc_system(SYS_sched_setaffinity, thread, where->bytes, where->word) == 0;
}

bool redcc_processors_move(long thread, const struct processors *these,
                           const struct processors *allowed) {
    return these->bytes > 0 && place(thread, these) && place(thread, allowed);
}

int redcc_processors_here(void) {
    const struct processors all = redcc_processors_of(0);
    int count = 0;
    for (long word = 0; word < words_of(&all); word++)
        count += __builtin_popcountl(all.word[word]);
    return count > 0 ? count : 1;
}

#else

#include <unistd.h>

struct processors redcc_processors_of(long thread) {
    (void)thread;
    return (struct processors){.bytes = 0};
}

struct processors redcc_processors_without(struct processors these, const unsigned long *taken,
                                           size_t words) {
    (void)taken;
    (void)words;
    return these;
}

struct processors redcc_processors_only(struct processors these, int core) {
    (void)core;
    return these;
}

bool redcc_processors_move(long thread, const struct processors *these,
                           const struct processors *allowed) {
    (void)thread;
    (void)these;
    (void)allowed;
    return false;
}

int redcc_processors_here(void) {
    const long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count > 0 ? (int)count : 1;
}

#endif

bool redcc_processors_leave(const unsigned long *taken, size_t words) {
    const struct processors all = redcc_processors_of(0);
    const struct processors others = redcc_processors_without(all, taken, words);
    return redcc_processors_move(0, &others, &all);
}
