/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Addresses that some of the iterations touch, spread evenly over the loop: what the cuts are
 * chosen from. One for each thread.
 */
#ifndef REDCC_SAMPLE_H
#define REDCC_SAMPLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct sampled {
    uintptr_t address;
    uint32_t array;
    uint32_t iteration; /* of this thread's sample, counted from 0 */
    uint32_t touch;     /* of this iteration, counted from 0 */
};

struct sample {
    struct sampled *item;
    size_t count;
    size_t capacity;
    uint64_t keep_each; /* touches that one kept item stands for; a power of two */
    uint64_t first;     /* sampled iterations of the threads before */
    uint32_t iterations;
    uint32_t touches; /* of the iteration at hand */
};

/** An empty one that keeps at most `capacity` touches, of a thread before whose share `first`
 *  iterations are sampled. False: no memory (end it all the same). */
bool redcc_sample_begin(struct sample *sample, size_t capacity, uint64_t first);

/** Gives back its memory. */
void redcc_sample_end(struct sample *sample);

/** Takes a touch in. When full, about half of the items are dropped and half as many are kept from
 *  then on, so that loops with thousands of touches an iteration are sampled evenly as well. Which
 *  ones, an even sequence of iteration and touch decides, not their rank: loops touch their arrays
 * in turn, and every fourth touch might be of one array only; nor a hash, which leaves more of one
 * part than of another. */
void redcc_sample_add(struct sample *sample, uintptr_t address, uint32_t array);

/** Drops items until one stands for `keep_each` touches. */
void redcc_sample_thin(struct sample *sample, uint64_t keep_each);

/** How many items redcc_sample_thin would leave. */
size_t redcc_sample_count(const struct sample *sample, uint64_t keep_each);

/** What follows belongs to the next iteration. */
static inline void redcc_sample_next_iteration(struct sample *sample) {
    sample->iterations++;
    sample->touches = 0;
}

#endif
