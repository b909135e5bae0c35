/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/estimate.h"

#include <assert.h>

#include "base/memory.h"
#include "ownership/owner_map.h"

/* Counts for an owner, or for a share (an owner with its stealable blocks): how many iterations
 * touch it, and the number of the last of them, counted from 1. */
struct part {
    uint32_t iterations;
    uint32_t last;
};
struct parts {
    struct part *of_owner; /* [owners] */
    struct part *of_share; /* [owners / (1 + stealable)] */
};

static void take_part(struct part *part, uint32_t iteration) {
    part->iterations += part->last != iteration;
    part->last = iteration;
}

/* The lowest and the highest owner that an iteration touches. */
struct span_of_owners {
    uint32_t low;
    uint32_t high;
};

/* Is item i the first touch of its iteration at its address? Searches only the 32 items before it,
 * so it may be true by mistake. */
static bool is_new_row(const struct sample *sample, size_t i) {
    enum { LOOKED_BACK = 32 };
    const struct sampled *item = &sample->item[i];
    for (size_t back = 1; back <= i && back <= LOOKED_BACK; back++) {
        if (item[-(ptrdiff_t)back].iteration != item->iteration)
            return true;
        if (item[-(ptrdiff_t)back].address == item->address)
            return false;
    }
    return true;
}

/* How often consecutive iterations of a sample touch different owners, and different shares. */
struct changes {
    uint32_t of_owners;
    uint32_t of_shares;
};

static void note_change(struct changes *changes, struct span_of_owners before,
                        struct span_of_owners now, uint32_t each) {
    if (before.low > before.high) /* there is none before */
        return;
    changes->of_owners += now.low != before.low || now.high != before.high;
    changes->of_shares +=
        now.low / each != before.low / each || now.high / each != before.high / each;
}

/* Counts, for each owner and each share, the iterations in a thread's sample that touch it. Adds to
 * *changes how often the owners, and the shares, of consecutive sampled iterations differ. */
static void count_parts(const struct partition *partition, const struct sample *sample,
                        uint32_t first, struct parts parts, struct changes *changes) {
    const uint32_t each = 1 + partition->stealable;
    const bool is_mapped = partition->map.owner;
    const struct span_of_owners none = {UINT32_MAX, 0};
    struct span_of_owners before = none, now = none;
    for (size_t i = 0; i < sample->count; i++) {
        const struct sampled *item = &sample->item[i];
        const uint32_t group = partition->group_of[item->array];
        const uint32_t owner = is_mapped
                                   ? redcc_mapped_owner(partition, group, item->address) * each
                                   : redcc_owner_of(partition, group, item->address);
        const uint32_t iteration = first + item->iteration;
        if (i > 0 && item->iteration != sample->item[i - 1].iteration) {
            note_change(changes, before, now, each);
            before = now;
            now = none;
        }
        now.low = owner < now.low ? owner : now.low;
        now.high = owner > now.high ? owner : now.high;
        take_part(&parts.of_owner[owner], iteration);
        take_part(&parts.of_share[owner / each], iteration);
    }
}

/* Adds a thread's sample to *all. */
static void count_touches(const struct partition *partition, const struct sample *sample,
                          struct touching *all) {
    const double each = (double)sample->keep_each;
    all->records += (double)sample->records;
    for (size_t i = 0; i < sample->count; i++) {
        all->touches += each;
        if (!is_new_row(sample, i))
            continue;
        if (partition->group_of[sample->item[i].array] == partition->leader)
            all->leading_rows += each;
        else
            all->further_rows += each;
    }
}

bool redcc_estimate(const struct partition *partition, const struct sample *const *sample,
                    int threads, struct estimate *estimate) {
    const size_t owners = partition->owners, shares = owners / (1 + partition->stealable);
    struct part *part = redcc_memory_alloc_zeroed(owners + shares, sizeof *part);
    assert(threads >= 1 && shares >= 1 && owners % shares == 0);
    if (!part)
        return false;
    const struct parts parts = {part, part + owners};
    uint32_t iterations = 1, most = 0, overhead = 0;
    struct changes changes = {0, 0};
    struct touching all = {0};
    for (int thread = 0; thread < threads; thread++) {
        count_parts(partition, sample[thread], iterations, parts, &changes);
        iterations += sample[thread]->iterations + 1;
        count_touches(partition, sample[thread], &all);
    }
    for (size_t owner = 0; owner < owners; owner++)
        overhead += parts.of_owner[owner].iterations;
    for (size_t share = 0; share < shares; share++) {
        const uint32_t taken = parts.of_share[share].iterations;
        most = taken > most ? taken : most;
        overhead -= taken;
    }
    *estimate = (struct estimate){.share = (double)most / iterations,
                                  .overhead = (double)overhead / iterations,
                                  .each = {.touches = all.touches / iterations,
                                           .records = all.records / iterations,
                                           .leading_rows = all.leading_rows / iterations,
                                           .further_rows = all.further_rows / iterations},
                                  .changes = (double)changes.of_owners / iterations,
                                  .share_changes = (double)changes.of_shares / iterations};
    redcc_memory_free(part);
    return true;
}
