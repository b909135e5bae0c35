/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/sample.h"

#include <assert.h>

#include "base/memory.h"

bool redcc_sample_begin(struct sample *sample, size_t capacity, uint64_t first) {
    assert(capacity > 0);
    *sample = (struct sample){.capacity = capacity, .keep_each = 1, .first = first};
    sample->item = redcc_memory_alloc(capacity * sizeof *sample->item);
    return sample->item != NULL;
}

void redcc_sample_end(struct sample *sample) {
    redcc_memory_free(sample->item);
    *sample = (struct sample){0};
}

/* Is this touch selected, if on average one touch in `in` (a power of two) is to be selected? The
 * touches that are selected for a larger `in` are also selected for a smaller one. Touch t of
 * iteration i has the fraction i / g + t / g^2 mod 1, where g is the real root of g^3 = g + 1. It
 * is selected if the fraction is at most 1 / in. These fractions are evenly distributed over every
 * interval of iterations and of touches (Roberts, The unreasonable effectiveness of quasirandom
 * sequences, 2018). They are computed in units of 2^-64. */
static bool chosen(uint64_t iteration, uint32_t touch, uint64_t in) {
    const uint64_t fraction = iteration * 0xc13fa9a902a6328fu + touch * 0x91e10da5c79e7b1du;
    return fraction <= UINT64_MAX / in;
}

/* The smallest n such that touch number `touch` + n is selected; `count` if there is no such n
 * below `count`. */
static uint32_t first_chosen(uint64_t iteration, uint32_t touch, uint32_t count, uint64_t in) {
    uint64_t fraction = iteration * 0xc13fa9a902a6328fu + touch * 0x91e10da5c79e7b1du;
    uint32_t n = 0;
    while (n < count && fraction > UINT64_MAX / in) {
        fraction += 0x91e10da5c79e7b1du;
        n++;
    }
    return n;
}

static bool stays(const struct sample *sample, const struct sampled *item, uint64_t keep_each) {
    return chosen(sample->first + item->iteration, item->touch, keep_each);
}

size_t redcc_sample_count(const struct sample *sample, uint64_t keep_each) {
    assert(keep_each >= sample->keep_each); /* dropped items cannot be restored */
    size_t count = 0;
    if (keep_each == sample->keep_each)
        return sample->count;
    for (size_t i = 0; i < sample->count; i++)
        count += stays(sample, &sample->item[i], keep_each);
    return count;
}

void redcc_sample_thin(struct sample *sample, uint64_t keep_each) {
    assert(keep_each >= sample->keep_each && (keep_each & (keep_each - 1)) == 0);
    size_t kept = 0;
    if (keep_each == sample->keep_each)
        return; /* the items were already selected at this rate */
    for (size_t i = 0; i < sample->count; i++)
        if (stays(sample, &sample->item[i], keep_each))
            sample->item[kept++] = sample->item[i];
    sample->count = kept;
    sample->keep_each = keep_each;
}

static void add_one(struct sample *sample, struct sampled item) {
    while (sample->count == sample->capacity) {
        redcc_sample_thin(sample, 2 * sample->keep_each);
        if (!stays(sample, &item, sample->keep_each))
            return;
    }
    sample->item[sample->count++] = item;
}

void redcc_sample_add(struct sample *sample, uintptr_t address, uint32_t array, uint32_t count,
                      uint32_t step) {
    assert(sample->count <= sample->capacity);
    const uint64_t iteration = sample->first + sample->iterations;
    const uint32_t before = sample->touches;
    sample->touches += count;
    sample->records++;
    for (uint32_t n = 0; n < count; n++) {
        n += first_chosen(iteration, before + n, count - n, sample->keep_each);
        if (n < count)
            add_one(sample, (struct sampled){address + (uintptr_t)n * step, array,
                                             sample->iterations, before + n});
    }
}
