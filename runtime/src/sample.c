/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "sample.h"

#include "memory.h"

bool redcc_sample_begin(struct sample *sample, size_t capacity) {
    *sample = (struct sample){.capacity = capacity, .keep_each = 1, .random = 1};
    sample->item = redcc_memory_take(capacity * sizeof *sample->item);
    return sample->item != NULL;
}

void redcc_sample_end(struct sample *sample) {
    redcc_memory_give(sample->item);
    *sample = (struct sample){0};
}

/* True once in `in` calls on average; `in` is a power of two. */
static bool chance(struct sample *sample, uint64_t in) {
    sample->random =
        sample->random * 6364136223846793005u + 1442695040888963407u; /* Knuth's MMIX */
    return (sample->random >> 33 & (in - 1)) == 0;
}

static void drop_half(struct sample *sample) {
    size_t kept = 0;
    for (size_t i = 0; i < sample->count; i++)
        if (chance(sample, 2))
            sample->item[kept++] = sample->item[i];
    sample->count = kept;
    sample->keep_each *= 2;
}

void redcc_sample_add(struct sample *sample, uintptr_t address, uint32_t array) {
    if (sample->keep_each > 1 && !chance(sample, sample->keep_each))
        return;
    while (sample->count == sample->capacity)
        drop_half(sample);
    sample->item[sample->count++] = (struct sampled){address, array, sample->iterations};
}
