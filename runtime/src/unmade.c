/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "unmade.h"

#include "learn/back_off.h"

#include <assert.h>
#include <stdint.h>

/* Seconds. An execution of at least this duration is worth a state: waking threads for it pays on
 * an idle machine. (The learner decides again, with the measured cost of waking threads.) */
static const double least_seconds = LEARN_WAKES * LEARN_SAMPLE / 40;

/* Seconds. A loop gets a state once its executions have taken this time in total. A state, together
 * with the one-time initialisation of the process, costs 0.04 to 0.3 ms, which is small compared
 * with this time. Before that, no inspection could pay off. */
static const double enough = 12.5 * LEARN_SAMPLE;

/* Layout of the word in loop->state: the lowest bit is 1, which distinguishes the word from a
 * pointer. The fields of struct word follow in order, with these numbers of bits. */
enum {
    SIZE_BITS = 7,
    NUMBER_BITS = 12, /* `left` and `length`, each */
    EARNED_BITS = 13
};

_Static_assert(8 * sizeof(void *) > SIZE_BITS + 2 * NUMBER_BITS + EARNED_BITS, "one word");

struct word {
    unsigned size;   /* the base-2 logarithm of the trip count */
    unsigned left;   /* number of calls until the loop is timed again */
    unsigned length; /* number of calls between two timings */
    unsigned earned; /* estimated total time, in microseconds, of the executions so far, including
                        those not timed; 0 if the last timed one took less than least_seconds or had
                        a smaller trip count */
};

static unsigned size_of(redcc_int trip) {
    return 63 - (unsigned)__builtin_clzll((unsigned long long)trip | 1);
}

static struct word unpack(const void *state) {
    const uintptr_t it = (uintptr_t)state >> 1, number = (1u << NUMBER_BITS) - 1;
    return (struct word){.size = (unsigned)it & ((1u << SIZE_BITS) - 1),
                         .left = (unsigned)(it >> SIZE_BITS & number),
                         .length = (unsigned)(it >> (SIZE_BITS + NUMBER_BITS) & number),
                         .earned = (unsigned)(it >> (SIZE_BITS + 2 * NUMBER_BITS)) &
                                   ((1u << EARNED_BITS) - 1)};
}

/* Replaces the word, unless another thread has changed it since `before` was read. */
static void replace(void **state, void *before, struct word word) {
    const uintptr_t it = (uintptr_t)word.size | (uintptr_t)word.left << SIZE_BITS |
                         (uintptr_t)word.length << (SIZE_BITS + NUMBER_BITS) |
                         (uintptr_t)word.earned << (SIZE_BITS + 2 * NUMBER_BITS);
    __atomic_compare_exchange_n(state, &before, (void *)(it << 1 | 1), 0, __ATOMIC_RELAXED,
                                __ATOMIC_RELAXED);
}

/* Is this call counted? One call in EACH is counted, and stands for EACH calls. Counting every call
 * would be slow, because a locked instruction takes as long as twenty additions. Calls are selected
 * by steps of the golden ratio, so that loops that are called alternately are counted equally
 * often. */
enum { EACH = 16 };
static bool counts(void) {
    static _Thread_local uint32_t place;
    place += 0x9E3779B9u;
    return place < UINT32_MAX / EACH;
}

bool redcc_unmade_call(void **state, redcc_int trip) {
    assert(trip >= 0);
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

/* The estimated seconds of all calls before this one, at most `enough`: the estimate at the last
 * timing, plus `seconds` (the time of this call) for each call since. */
static double earned_before(struct word word, double seconds) {
    const double timed = word.earned * 1e-6, left = enough - timed, between = seconds * word.length;
    return timed + (between < left ? between : left);
}

int redcc_unmade_timed(void **state, redcc_int trip, double seconds) {
    void *const before = __atomic_load_n(state, __ATOMIC_RELAXED);
    if (!redcc_is_unmade(before))
        return 1;
    struct word word = unpack(before);
    const unsigned size = size_of(trip);
    const bool is_smaller = before && size < word.size, is_same = before && size == word.size;
    const double earned = seconds + (is_same && word.earned > 0 ? earned_before(word, seconds) : 0);
    if (seconds >= least_seconds && earned >= enough)
        return (int)(earned / seconds);
    const bool earns = seconds >= least_seconds && !is_smaller;
    word.earned = earns ? (unsigned)(1e6 * earned) + 1 : 0;
    word.length = earns                   ? (unsigned)((enough - earned) / seconds)
                  : is_same || is_smaller ? (unsigned)redcc_longer(word.length)
                                          : LEARN_BACK_OFF;
    word.left = word.length;
    word.size = is_smaller ? word.size : size;
    replace(state, before, word);
    return 0;
}
