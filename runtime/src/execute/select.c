/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/select.h"

#include "base/share.h"

#include <assert.h>
#include <stdint.h>
#include <string.h>

enum { WORD = 64 }; /* number of bits */
_Static_assert(REDCC_SELECTED == WORD * REDCC_SELECTED_WORDS, "a bit for each iteration");

void redcc_selection_begin(struct selection *selection, redcc_worker *worker, redcc_int trip) {
    assert(trip >= 0);
    selection->trip = selection->end = trip;
    selection->idle_begin = selection->idle_end = 0;
    selection->executed = 0;
    selection->taken = 0;
    selection->asked = selection->surveys = false;
    selection->survey = NULL;
    worker->first = worker->last = 0;
    worker->window = selection->window;
}

void redcc_selection_set_idle(struct selection *selection, redcc_int begin, redcc_int end) {
    assert(0 <= begin && begin <= end && end <= selection->trip);
    selection->idle_begin = begin;
    selection->idle_end = end;
}

/* The end of the block of iterations that begins with worker->first. */
static redcc_int end_of_block(const struct selection *selection, const redcc_worker *worker) {
    const redcc_int left = selection->end - worker->first;
    return worker->first + (left < REDCC_SELECTED ? left : REDCC_SELECTED);
}

static void ask(struct selection *selection, redcc_worker *worker) {
    worker->last = end_of_block(selection, worker);
    worker->stride = 1;
    worker->entry = (redcc_entry *)(void *)selection->class;
    selection->asked = true;
}

static bool is_in_share(const struct selection *selection, redcc_int iteration) {
    return selection->share_begin <= iteration && iteration < selection->share_end;
}

bool redcc_selection_ask(struct selection *selection, redcc_worker *worker) {
    const struct survey *survey = selection->survey;
    assert(!selection->asked && worker->last <= selection->end);
    redcc_int first = worker->last;
    while (survey && first < selection->end && !is_in_share(selection, first) &&
           !survey->is_open[first / REDCC_SELECTED])
        first += REDCC_SELECTED;
    selection->taken = 0;
    if (first >= selection->end) {
        worker->first = worker->last = selection->end;
        return false;
    }
    worker->first = first;
    if (survey && is_in_share(selection, first)) {
        worker->last = end_of_block(selection, worker);
        memcpy(selection->bits, survey->block[first / REDCC_SELECTED].bits, sizeof selection->bits);
    } else {
        ask(selection, worker);
    }
    return true;
}

/* Loads eight classes, the first one in the lowest byte. Compilers make this one load. */
static uint64_t load_eight(const unsigned char *class) {
    return (uint64_t) class[0] | (uint64_t) class[1] << 8 | (uint64_t) class[2] << 16 |
           (uint64_t) class[3] << 24 | (uint64_t) class[4] << 32 | (uint64_t) class[5] << 40 |
           (uint64_t) class[6] << 48 | (uint64_t) class[7] << 56;
}

/* Gathers the lowest bits of eight bytes in one byte. The multiplication adds eight shifted copies
 * of `eight`. In its highest byte, each bit comes from another copy. */
static uint64_t gather_lowest(uint64_t eight) {
    return (eight & 0x0101010101010101u) * 0x0102040810204080u >> 56;
}

/* The bits of the iterations from `begin` to before `end`, in the word whose lowest bit belongs to
 * iteration `first`. */
static uint64_t bits_between(redcc_int begin, redcc_int end, redcc_int first) {
    const redcc_int low = begin > first ? begin - first : 0, high = end - first;
    if (low >= WORD || high <= low)
        return 0;
    return (high >= WORD ? UINT64_MAX : ((uint64_t)1 << high) - 1) & UINT64_MAX << low;
}

/* Stores the classes as bits. The thread does not execute an iteration that touches nothing, unless
 * it is in [idle_begin, idle_end). Returns whether other threads own elements that are touched. */
static bool set_bits(struct selection *selection, const redcc_worker *worker) {
    uint64_t all_others = 0;
    for (redcc_int w = 0; w < REDCC_SELECTED_WORDS; w++) {
        const redcc_int first = worker->first + w * WORD;
        const uint64_t asked = bits_between(worker->first, worker->last, first);
        uint64_t own = 0, others = 0, leads = 0;
        for (redcc_int k = 0; k < WORD; k += 8) {
            const uint64_t eight = load_eight(&selection->class[w * WORD + k]);
            own |= gather_lowest(eight / REDCC_CLASS_OWN) << k;
            others |= gather_lowest(eight / REDCC_CLASS_OTHERS) << k;
            leads |= gather_lowest(eight / REDCC_CLASS_LEADS) << k;
        }
        own &= asked;
        const uint64_t idle = asked & ~(own | others) &
                              bits_between(selection->idle_begin, selection->idle_end, first);
        selection->bits[w] = (struct class_bits){own | idle, own & others, own & ~leads};
        all_others |= others & asked;
    }
    return all_others != 0;
}

void redcc_selection_survey(struct selection *selection, redcc_worker *worker,
                            struct survey *survey, int thread, bool idle) {
    selection->survey = survey;
    selection->surveys = true;
    selection->share_begin = redcc_survey_first(survey, thread);
    selection->share_end = redcc_min(redcc_survey_first(survey, thread + 1), selection->trip);
    if (idle)
        redcc_selection_set_idle(selection, selection->share_begin, selection->share_end);
    worker->first = worker->last = selection->share_begin;
}

/* Keeps the classes of the block. False: an iteration has left a fence. */
static bool keep(struct selection *selection, const redcc_worker *worker) {
    struct survey *survey = selection->survey;
    const redcc_int block = worker->first / REDCC_SELECTED;
    survey->is_open[block] = set_bits(selection, worker);
    memcpy(survey->block[block].bits, selection->bits, sizeof selection->bits);
    return worker->last == end_of_block(selection, worker);
}

bool redcc_selection_ask_survey(struct selection *selection, redcc_worker *worker, int thread) {
    assert(selection->surveys);
    const bool goes_on = !selection->asked || keep(selection, worker);
    selection->asked = false;
    if (goes_on && worker->last < selection->share_end) {
        worker->first = worker->last;
        ask(selection, worker);
        return true;
    }
    selection->surveys = false;
    selection->end = redcc_survey_end(selection->survey, thread, worker->last);
    worker->first = worker->last = 0;
    return false;
}

/* The number of bits from bit `bit` of a word to before the next bit that is set in `ends`, or to
 * the word's end. */
static redcc_int length_until(uint64_t ends, unsigned bit) {
    const redcc_int left = (redcc_int)(WORD - bit);
    const redcc_int length = ends >> bit ? __builtin_ctzll(ends >> bit) : left;
    return length < left ? length : left;
}

/* Is it faster to hand out each executed iteration of the word as a separate run? The end of a
 * longer run costs about one mispredicted branch, which takes as long as the beginnings of six
 * runs. With lanes or prefetches it is not faster, because each run then begins with a call. All
 * iterations must have the same value of `follows`. */
static bool is_scattered(const struct class_bits *bits, const redcc_variant *variant) {
    const uint64_t executed = bits->executed;
    const int runs = __builtin_popcountll(executed & ~(executed << 1));
    return 6 * runs > __builtin_popcountll(executed) && !variant->lanes && !variant->prefetches &&
           (bits->follows == 0 || bits->follows == executed);
}

/* Writes each executed iteration of the word as a separate run, without branches that depend on the
 * classes. Returns the number of runs. */
static size_t take_each(const struct class_bits *bits, redcc_int first, bool hooked,
                        redcc_iterations *to) {
    size_t runs = 0;
    for (uint64_t left = bits->executed; left; left &= left - 1) {
        const unsigned bit = (unsigned)__builtin_ctzll(left);
        const redcc_u32 check = hooked || bits->shared >> bit & 1;
        to[runs++] = (redcc_iterations){(redcc_u32)first + bit, 2 + check};
    }
    return runs;
}

/* A word with all bits set if `is_set`, otherwise 0. */
static uint64_t all_if(bool is_set) {
    return is_set ? UINT64_MAX : 0;
}

/* Branches once for each run, not once for each iteration, because classes in random order would
 * make such branches unpredictable. */
size_t redcc_selection_take(struct selection *selection, const redcc_worker *worker, bool hooked,
                            redcc_iterations *to, redcc_int *iterations) {
    const redcc_int count = worker->last - worker->first;
    size_t runs = 0;
    bool is_open = false;
    assert(0 <= count && count <= REDCC_SELECTED);
    if (selection->asked) {
        selection->taken = 0;
        if (worker->last < end_of_block(selection, worker)) /* an iteration leaves a fence */
            selection->end = worker->last;
        set_bits(selection, worker);
    }
    selection->asked = false;
    *iterations = 0;
    while (selection->taken < count) {
        const redcc_int first = selection->taken;
        const struct class_bits *bits = &selection->bits[first / WORD];
        const unsigned bit = (unsigned)(first % WORD);
        const uint64_t shared = hooked ? 0 : bits->shared;
        if (bit == 0 && is_scattered(bits, &worker->variant)) {
            const bool follows = bits->follows != 0;
            if (runs > 0 && follows != selection->follows)
                break;
            selection->follows = follows;
            const size_t more = take_each(bits, first, hooked, to + runs);
            runs += more;
            *iterations += (redcc_int)more;
            selection->taken += WORD;
            is_open = false;
            continue;
        }
        if (!(bits->executed >> bit & 1)) {
            selection->taken += length_until(bits->executed, bit);
            is_open = false;
            continue;
        }
        const bool follows = bits->follows >> bit & 1, is_shared = shared >> bit & 1;
        if (runs > 0 && follows != selection->follows)
            break;
        selection->follows = follows;
        const redcc_int length = length_until(~bits->executed | (shared ^ all_if(is_shared)) |
                                                  (bits->follows ^ all_if(follows)),
                                              bit);
        const redcc_u32 check = hooked || is_shared;
        if (is_open && (to[runs - 1].count_and_check & 1) == check)
            to[runs - 1].count_and_check += 2 * (redcc_u32)length;
        else
            to[runs++] = (redcc_iterations){(redcc_u32)first, 2 * (redcc_u32)length + check};
        is_open = true;
        selection->taken += length;
        *iterations += length;
    }
    if (selection->taken > count)
        selection->taken = count;
    selection->executed += *iterations;
    return runs;
}
