/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "cuts.h"

#include "memory.h"

#include <string.h>

/* A touch of one group, and which iteration of all samples it belongs to. */
struct point {
    uintptr_t address;
    uint32_t iteration;
};

/* The owners in the leading group that an iteration touches; low > high: none. */
struct label {
    uint32_t low;
    uint32_t high;
};

struct work {
    struct partition *partition;
    const struct sample *const *sample;
    int threads;
    struct point *point; /* of the group at hand, sorted by address */
    struct point *spare;
    size_t count;
    struct label *label;  /* of every sampled iteration */
    struct label *beside; /* of the iterations of the points */
};

static void gather(struct work *work, uint32_t group) {
    work->count = 0;
    uint32_t first_iteration = 0;
    for (int thread = 0; thread < work->threads; thread++) {
        const struct sample *sample = work->sample[thread];
        for (size_t i = 0; i < sample->count; i++) {
            const struct sampled *item = &sample->item[i];
            if (work->partition->group_of[item->array] == group)
                work->point[work->count++] =
                    (struct point){item->address, first_iteration + item->iteration};
        }
        first_iteration += sample->iterations + 1;
    }
}

/* Least significant digit first, in digits of 11 bits; digits that are the same everywhere are
 * skipped. */
static void sort_by_address(struct work *work) {
    enum { BITS = 11, BUCKETS = 1 << BITS };
    uintptr_t differ = 0;
    for (size_t i = 1; i < work->count; i++)
        differ |= work->point[i].address ^ work->point[0].address;
    for (unsigned shift = 0; shift < 8 * sizeof(uintptr_t); shift += BITS) {
        if (!(differ >> shift & (BUCKETS - 1)))
            continue;
        size_t start[BUCKETS + 1] = {0};
        for (size_t i = 0; i < work->count; i++)
            start[(work->point[i].address >> shift & (BUCKETS - 1)) + 1]++;
        for (int bucket = 0; bucket < BUCKETS; bucket++)
            start[bucket + 1] += start[bucket];
        for (size_t i = 0; i < work->count; i++)
            work->spare[start[work->point[i].address >> shift & (BUCKETS - 1)]++] = work->point[i];
        struct point *sorted = work->spare;
        work->spare = work->point;
        work->point = sorted;
    }
}

static void close_cuts(const struct partition *partition, uint32_t group) {
    uintptr_t *cut = redcc_cuts(partition, group);
    cut[0] = 0;
    for (uint32_t owner = 1; owner < partition->owners; owner++)
        if (cut[owner] < cut[owner - 1])
            cut[owner] = cut[owner - 1];
    cut[partition->owners] = UINTPTR_MAX;
}

/* Equal shares of the touches. Returns how many different cuts there are. */
static uint32_t cut_at_quantiles(struct work *work, uint32_t group) {
    const struct partition *partition = work->partition;
    uintptr_t *cut = redcc_cuts(partition, group);
    uint32_t different = 0;
    for (uint32_t owner = 1; owner < partition->owners; owner++) {
        const size_t rank = work->count * owner / partition->owners;
        cut[owner] =
            work->count ? redcc_unit_begin(partition, group, work->point[rank].address) : 0;
        different += cut[owner] != cut[owner - 1];
    }
    close_cuts(partition, group);
    return different;
}

static void label_iterations(struct work *work, uint32_t group, size_t iterations) {
    for (size_t i = 0; i < iterations; i++)
        work->label[i] = (struct label){UINT32_MAX, 0};
    for (size_t i = 0; i < work->count; i++) {
        const uint32_t owner = redcc_owner_of(work->partition, group, work->point[i].address);
        struct label *label = &work->label[work->point[i].iteration];
        label->low = owner < label->low ? owner : label->low;
        label->high = owner > label->high ? owner : label->high;
    }
}

/* Where between the points does a cut part best the iterations wholly below owner `owner` from
 * those wholly at or above it? Of equally good places, the middle one. */
static uintptr_t best_cut(const struct work *work, uint32_t group, uint32_t owner) {
    long cost = 0;
    for (size_t i = 0; i < work->count; i++) {
        const struct label label = work->beside[i];
        cost += label.low <= label.high && label.high < owner;
    }
    long least = cost;
    size_t first = 0, last = 0;
    for (size_t i = 0; i < work->count; i++) { /* the cut moves from before point i to after it */
        const struct label label = work->beside[i];
        if (label.low <= label.high)
            cost += (label.low >= owner) - (label.high < owner);
        if (cost < least) {
            least = cost;
            first = i + 1;
        }
        if (cost == least)
            last = i + 1;
    }
    last = last < first ? first : last;
    const size_t place = first + (last - first) / 2;
    if (place == work->count) /* everything is below: nothing is left to the owners above */
        return UINTPTR_MAX;
    return redcc_unit_begin(work->partition, group, work->point[place].address);
}

static void cut_beside_leader(struct work *work, uint32_t group) {
    const struct partition *partition = work->partition;
    bool labelled = false;
    for (size_t i = 0; i < work->count; i++) {
        work->beside[i] = work->label[work->point[i].iteration];
        labelled = labelled || work->beside[i].low <= work->beside[i].high;
    }
    if (!labelled)
        return; /* never touched together with the leading group: its own quantiles stay */
    uintptr_t *cut = redcc_cuts(partition, group);
    for (uint32_t owner = 1; owner < partition->owners; owner++)
        cut[owner] = best_cut(work, group, owner);
    close_cuts(partition, group);
}

static void cut_all(struct work *work, size_t iterations) {
    struct partition *partition = work->partition;
    uint32_t leader = UINT32_MAX, most = 0, groups = 0;
    for (uint32_t group = 0; group < partition->array_count; group++) {
        if (!redcc_leads_group(partition, group))
            continue;
        gather(work, group);
        sort_by_address(work);
        const uint32_t different = cut_at_quantiles(work, group);
        if (leader == UINT32_MAX || different > most) {
            leader = group;
            most = different;
        }
        groups++;
    }
    partition->leader = leader == UINT32_MAX ? 0 : leader;
    if (groups < 2 || partition->owners < 2)
        return;
    gather(work, leader);
    label_iterations(work, leader, iterations);
    for (uint32_t group = 0; group < partition->array_count; group++) {
        if (!redcc_leads_group(partition, group) || group == leader)
            continue;
        gather(work, group);
        sort_by_address(work);
        cut_beside_leader(work, group);
    }
}

bool redcc_choose_cuts(struct partition *partition, const struct sample *const *sample,
                       int threads) {
    size_t points = 1, iterations = 1;
    for (int thread = 0; thread < threads; thread++) {
        points += sample[thread]->count;
        iterations += (size_t)sample[thread]->iterations + 1;
    }
    struct work work = {.partition = partition, .sample = sample, .threads = threads};
    work.point = redcc_memory_take(points * sizeof *work.point);
    work.spare = redcc_memory_take(points * sizeof *work.spare);
    work.label = redcc_memory_take(iterations * sizeof *work.label);
    work.beside = redcc_memory_take(points * sizeof *work.beside);
    const bool enough = work.point && work.spare && work.label && work.beside;
    if (enough)
        cut_all(&work, iterations);
    redcc_memory_give(work.point);
    redcc_memory_give(work.spare);
    redcc_memory_give(work.label);
    redcc_memory_give(work.beside);
    return enough;
}
