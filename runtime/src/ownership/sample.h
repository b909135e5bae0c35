/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A sample of the touched addresses, from iterations that are spread evenly over the loop. The cuts
 * and estimates are based on it. Each thread has one sample.
 */
#ifndef REDCC_SAMPLE_H
#define REDCC_SAMPLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct sampled {
    uintptr_t address;
    uint32_t array;
    uint32_t iteration; /* number of the iteration within this thread's sample, counted from 0 */
    uint32_t touch;     /* number of the touch within its iteration, counted from 0 */
};

struct sample {
    struct sampled *item;
    size_t count;
    size_t capacity;
    uint64_t keep_each; /* number of touches that one item represents; a power of two */
    uint64_t first; /* number of sampled iterations in the shares of the threads before this one */
    uint32_t iterations;
    uint32_t touches; /* number of touches of the current iteration so far */
    uint64_t records; /* number of touches, with a block of rows counted as one */
};

/** Makes an empty sample of at most `capacity` touches. `first` is the number of sampled iterations
 * before the thread's share. Returns false if out of memory. Call redcc_sample_end in either
 * case. */
bool redcc_sample_begin(struct sample *sample, size_t capacity, uint64_t first);

/** Frees the sample's memory. */
void redcc_sample_end(struct sample *sample);

/** Adds `count` touches at intervals of `step` bytes. A full sample drops about half of its items,
 * and from then on samples half as many touches. So loops with thousands of touches per iteration
 * are sampled evenly, too. A quasirandom sequence over iterations and touches selects the items. If
 * every n-th touch were selected, all might be of the same array; a hash would leave more items in
 * one part of the loop than in another. */
void redcc_sample_add(struct sample *sample, uintptr_t address, uint32_t array, uint32_t count,
                      uint32_t step);

/** Drops items until each item represents `keep_each` touches. */
void redcc_sample_thin(struct sample *sample, uint64_t keep_each);

/** The number of items that redcc_sample_thin would leave. */
size_t redcc_sample_count(const struct sample *sample, uint64_t keep_each);

/** Begins the next iteration. */
static inline void redcc_sample_next_iteration(struct sample *sample) {
    sample->iterations++;
    sample->touches = 0;
}

#endif
