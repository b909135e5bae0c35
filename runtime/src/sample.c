/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "sample.h"

#include "memory.h"

bool redcc_sample_begin(struct sample *sample, size_t capacity) {
    *sample = (struct sample){.capacity = capacity, .keep_each = 1};
    sample->item = redcc_memory_take(capacity * sizeof *sample->item);
    return sample->item != NULL;
}

void redcc_sample_end(struct sample *sample) {
    redcc_memory_give(sample->item);
    *sample = (struct sample){0};
}

static void drop_every_other(struct sample *sample) {
    size_t kept = 0;
    for (size_t i = 0; i < sample->count; i += 2)
        sample->item[kept++] = sample->item[i];
    sample->count = kept;
    sample->keep_each *= 2;
}

void redcc_sample_add(struct sample *sample, uintptr_t address, uint32_t array) {
    if (++sample->passed < sample->keep_each)
        return;
    sample->passed = 0;
    if (sample->count == sample->capacity)
        drop_every_other(sample);
    sample->item[sample->count++] = (struct sampled){address, array, sample->iterations};
}
