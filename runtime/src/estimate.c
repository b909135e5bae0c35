/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "estimate.h"

#include "memory.h"

/* Of each owner: iterations that it takes part in, and the last one of them, counted from 1. */
struct part {
    uint32_t iterations;
    uint32_t last;
};

static void count_parts(const struct partition *partition, const struct sample *sample,
                        uint32_t first, struct part *part) {
    for (size_t i = 0; i < sample->count; i++) {
        const struct sampled *item = &sample->item[i];
        const uint32_t group = partition->group_of[item->array];
        struct part *owner = &part[redcc_owner_of(partition, group, item->address)];
        const uint32_t iteration = first + item->iteration;
        owner->iterations += owner->last != iteration;
        owner->last = iteration;
    }
}

bool redcc_estimate(const struct partition *partition, const struct sample *const *sample,
                    int threads, struct estimate *estimate) {
    struct part *part = redcc_memory_take_zeroed(partition->owners, sizeof *part);
    if (!part)
        return false;
    uint32_t iterations = 1, most = 0;
    double touches = 0;
    for (int thread = 0; thread < threads; thread++) {
        count_parts(partition, sample[thread], iterations, part);
        iterations += sample[thread]->iterations + 1;
        touches += (double)sample[thread]->count * (double)sample[thread]->keep_each;
    }
    for (uint32_t owner = 0; owner < partition->owners; owner++)
        most = part[owner].iterations > most ? part[owner].iterations : most;
    *estimate = (struct estimate){(double)most / iterations, touches / iterations};
    redcc_memory_give(part);
    return true;
}
