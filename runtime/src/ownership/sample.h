/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Addresses that some of the iterations touch, spread evenly over the loop: the cuts are chosen
 * from them. One sample per thread.
 */
#ifndef REDCC_SAMPLE_H
#define REDCC_SAMPLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct sampled {
    uintptr_t address;
    uint32_t array;
    uint32_t iteration; /* within this thread's sample, counted from 0 */
    uint32_t touch;     /* within this iteration, counted from 0 */
};

struct sample {
    struct sampled *item;
    size_t count;
    size_t capacity;
    uint64_t keep_each; /* touches that one kept item represents; a power of two */
    uint64_t first;     /* sampled iterations of the preceding threads */
    uint32_t iterations;
    uint32_t touches; /* of the current iteration */
    uint64_t records; /* of all iterations: the rows of a block are one */
};

/** An empty sample of at most `capacity` touches, for a thread with `first` sampled iterations
 *  before its share. False: no memory (call redcc_sample_end all the same). */
bool redcc_sample_begin(struct sample *sample, size_t capacity, uint64_t first);

/** Frees its memory. */
void redcc_sample_end(struct sample *sample);

/** Adds `count` touches, `step` bytes apart. A full sample drops about half of the items and halves
 * the rate from then on, so that loops with thousands of touches per iteration are sampled evenly
 * as well. An even sequence over iteration and touch selects the items. Ranks would not do: loops
 * touch their arrays in turn, and every fourth touch might be of one array only. Nor would a hash,
 * which leaves more items in one part than in another. */
void redcc_sample_add(struct sample *sample, uintptr_t address, uint32_t array, uint32_t count,
                      uint32_t step);

/** Drops items until each represents `keep_each` touches. */
void redcc_sample_thin(struct sample *sample, uint64_t keep_each);

/** The number of items that redcc_sample_thin would leave. */
size_t redcc_sample_count(const struct sample *sample, uint64_t keep_each);

/** Later touches belong to the next iteration. */
static inline void redcc_sample_next_iteration(struct sample *sample) {
    sample->iterations++;
    sample->touches = 0;
}

#endif
