/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "unmade.h"

#include <stdint.h>

/* Of an execution that is worth a state: 16 times as long as waking threads takes on a machine that
 * is not busy (decide.c asks again, with what it takes on this one). */
static const double least_seconds = 0.16e-3;

/* The state, and what is made once in a process, take 0.04 to 0.2 ms: a loop that takes no longer
 * than a few of these gets it when they are a 32nd of the time that it has taken. */
static const double at_once = 0.5e-3, enough = 5e-3;

enum {
    FIRST = 16,       /* calls until a short loop is timed again; then twice as many, */
    MOST = 1024,      /* up to these */
    SIZE_BITS = 7,    /* of the word, above the lowest bit, which is 1: a loop's size, */
    NUMBER_BITS = 12, /* calls that are left until it is timed again, and all of these */
};

struct word {
    unsigned size; /* the logarithm of the trip count */
    unsigned left;
    unsigned length;
};

static unsigned size_of(redcc_int trip) {
    return 63 - (unsigned)__builtin_clzll((unsigned long long)trip | 1);
}

static struct word unpack(const void *state) {
    const uintptr_t it = (uintptr_t)state >> 1, number = (1u << NUMBER_BITS) - 1;
    return (struct word){.size = (unsigned)it & ((1u << SIZE_BITS) - 1),
                         .left = (unsigned)(it >> SIZE_BITS & number),
                         .length = (unsigned)(it >> (SIZE_BITS + NUMBER_BITS) & number)};
}

/* Where another thread was quicker, its word stays, or the state that it has made. */
static void replace(void **state, void *before, struct word word) {
    const uintptr_t it = (uintptr_t)word.size | (uintptr_t)word.left << SIZE_BITS |
                         (uintptr_t)word.length << (SIZE_BITS + NUMBER_BITS);
    __atomic_compare_exchange_n(state, &before, (void *)(it << 1 | 1), 0, __ATOMIC_RELAXED,
                                __ATOMIC_RELAXED);
}

/* Does this call count, for so many? A locked instruction takes as long as twenty additions. The
 * steps are the golden ratio's, so that loops that are called in turn are counted alike. */
enum { EACH = 16 };
static bool counts(void) {
    static _Thread_local uint32_t place;
    place += 0x9E3779B9u;
    return place < UINT32_MAX / EACH;
}

bool redcc_unmade_call(void **state, redcc_int trip) {
    void *const before = __atomic_load_n(state, __ATOMIC_RELAXED);
    if (!before || !redcc_is_unmade(before))
        return true;
    struct word word = unpack(before);
    if (word.left == 0 || size_of(trip) > word.size)
        return true;
    const bool is_near = word.left <= EACH;
    if (is_near || counts()) {
        word.left -= is_near ? 1 : EACH;
        replace(state, before, word);
    }
    return false;
}

int redcc_unmade_timed(void **state, redcc_int trip, double seconds) {
    void *const before = __atomic_load_n(state, __ATOMIC_RELAXED);
    if (!redcc_is_unmade(before) || seconds >= at_once)
        return 1;
    struct word word = unpack(before);
    const unsigned size = size_of(trip);
    const bool is_known = before && size <= word.size;
    if (before && size == word.size && seconds >= least_seconds && seconds * word.length >= enough)
        return 1 + FIRST;
    word.length = is_known ? 2 * word.length : FIRST;
    word.length = word.length < MOST ? word.length : MOST;
    replace(state, before,
            (struct word){before && size < word.size ? word.size : size, word.length, word.length});
    return 0;
}
