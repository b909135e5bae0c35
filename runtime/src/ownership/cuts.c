/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/cuts.h"

#include "base/memory.h"

#include <assert.h>
#include <string.h>

/* A sampled touch of a group (ownership/partition.h): its address, and the number of its iteration
 * when the samples of all threads are concatenated. */
struct point {
    uintptr_t address;
    uint32_t iteration;
};

/* The lowest and the highest owner whose elements of the leading group an iteration touches. low >
 * high: the iteration touches no element of that group. */
struct label {
    uint32_t low;
    uint32_t high;
};

/* The sampled touches of a group, sorted by address. */
struct points {
    struct point *point;
    size_t count;
};

struct work {
    struct partition *partition;
    const struct sample *const *sample;
    int threads;
    struct points *points_of; /* [array_count] the points of each group */
    struct point *point;      /* memory for the points of all groups, one group after the other */
    struct point *spare;      /* scratch memory of the same size */
    struct label *label_of;   /* [iterations of the sample] */
    struct label *label_of_point; /* for each of a group's points, the label of its iteration */
};

/* Stores the group's touches from `point` on. */
static struct points gather(const struct work *work, uint32_t group, struct point *point) {
    struct points points = {point, 0};
    uint32_t first_iteration = 0;
    for (int thread = 0; thread < work->threads; thread++) {
        const struct sample *sample = work->sample[thread];
        for (size_t i = 0; i < sample->count; i++) {
            const struct sampled *item = &sample->item[i];
            if (work->partition->group_of[item->array] == group)
                point[points.count++] =
                    (struct point){item->address, first_iteration + item->iteration};
        }
        first_iteration += sample->iterations + 1; /* + 1: the last iteration may be incomplete */
    }
    return points;
}

enum { MOST_BITS = 11 }; /* maximum number of bits of a digit of the radix sort */

/* Stable counting sort of points by bits [shift, shift + bits) of the address. */
static void sort_by_digit(const struct point *from, struct point *to, size_t count, unsigned shift,
                          unsigned bits) {
    const uintptr_t mask = ((uintptr_t)1 << bits) - 1;
    size_t start[(1 << MOST_BITS) + 1];
    memset(start, 0, (mask + 2) * sizeof *start);
    for (size_t i = 0; i < count; i++)
        start[(from[i].address >> shift & mask) + 1]++;
    for (size_t bucket = 0; bucket < mask; bucket++)
        start[bucket + 1] += start[bucket];
    for (size_t i = 0; i < count; i++)
        to[start[from[i].address >> shift & mask]++] = from[i];
}

/* Radix sort, beginning with the least significant digit. Sorts only by the bits in which addresses
 * differ, in as few digits of equal length as possible. */
static void sort_by_address(struct points points, struct point *spare) {
    unsigned long long differ = 0;
    for (size_t i = 1; i < points.count; i++)
        differ |= points.point[i].address ^ points.point[0].address;
    if (!differ)
        return;
    const unsigned low = (unsigned)__builtin_ctzll(differ);
    const unsigned end = 64 - (unsigned)__builtin_clzll(differ);
    const unsigned digits = (end - low + MOST_BITS - 1) / MOST_BITS;
    const unsigned bits = (end - low + digits - 1) / digits;
    struct point *from = points.point, *to = spare;
    for (unsigned digit = 0; digit < digits; digit++) {
        struct point *const sorted = to;
        sort_by_digit(from, sorted, points.count, low + digit * bits, bits);
        to = from;
        from = sorted;
    }
    for (size_t i = 1; i < points.count; i++)
        assert(from[i - 1].address <= from[i].address);
    if (from != points.point)
        memcpy(points.point, from, points.count * sizeof *from);
}

/* Makes the cuts ascend, and sets the first cut to 0 and the last to UINTPTR_MAX. */
static void close_cuts(const struct partition *partition, uint32_t group) {
    uintptr_t *cut = redcc_cuts(partition, group);
    cut[0] = 0;
    for (uint32_t owner = 1; owner < partition->owners; owner++)
        if (cut[owner] < cut[owner - 1])
            cut[owner] = cut[owner - 1];
    cut[partition->owners] = UINTPTR_MAX;
}

/* Cuts a group at quantiles of its points. Returns the number of different cuts. */
static uint32_t cut_at_quantiles(const struct work *work, uint32_t group) {
    const struct partition *partition = work->partition;
    const struct points points = work->points_of[group];
    uintptr_t *cut = redcc_cuts(partition, group);
    uint32_t different = 0;
    for (uint32_t owner = 1; owner < partition->owners; owner++) {
        const size_t rank =
            redcc_amount_below(partition->owners, partition->stealable, owner, points.count);
        assert(rank < points.count || points.count == 0);
        cut[owner] =
            points.count ? redcc_unit_begin(partition, group, points.point[rank].address) : 0;
        different += cut[owner] != cut[owner - 1];
    }
    close_cuts(partition, group);
    return different;
}

static void label_iterations(const struct work *work, uint32_t group, size_t iterations) {
    const struct points points = work->points_of[group];
    for (size_t i = 0; i < iterations; i++)
        work->label_of[i] = (struct label){UINT32_MAX, 0};
    for (size_t i = 0; i < points.count; i++) {
        const uint32_t owner = redcc_owner_of(work->partition, group, points.point[i].address);
        struct label *label = &work->label_of[points.point[i].iteration];
        label->low = owner < label->low ? owner : label->low;
        label->high = owner > label->high ? owner : label->high;
    }
}

/* Suppose that the cut below owner `owner` moves from before a point to after it, and that the
 * point's iteration has this label. Returns by how much the number of points on the wrong side of
 * the cut changes. A point is on the wrong side if all owners of its iteration's label are on the
 * other side. */
static long change_beyond(struct label label, uint32_t owner) {
    return label.low > label.high ? 0 : (label.low >= owner) - (label.high < owner);
}

static size_t distance(size_t a, size_t b) {
    return a < b ? b - a : a - b;
}

/* The number of points below the best cut between owners `owner` - 1 and `owner`. It separates the
 * iterations whose owners are all below `owner` from those whose owners are all at least `owner`.
 * Among equally good cuts, takes the one nearest to the middle between the first and the last of
 * them. */
static size_t best_place(const struct label *of_point, size_t count, uint32_t owner) {
    long cost = 0, least = 0; /* cost relative to a cut before all points */
    size_t first = 0, last = 0;
    for (size_t i = 0; i < count; i++) {
        cost += change_beyond(of_point[i], owner);
        if (cost < least) {
            least = cost;
            first = i + 1;
        }
        if (cost == least)
            last = i + 1;
    }
    const size_t middle = first + (last - first) / 2;
    size_t best = first;
    cost = 0;
    for (size_t i = 0; i < last; i++) {
        cost += change_beyond(of_point[i], owner);
        if (cost == least && distance(i + 1, middle) < distance(best, middle))
            best = i + 1;
    }
    return best;
}

static uintptr_t best_cut(const struct work *work, uint32_t group, uint32_t owner) {
    const struct points points = work->points_of[group];
    const size_t place = best_place(work->label_of_point, points.count, owner);
    if (place == points.count) /* all points are below the cut: the owners above get nothing */
        return UINTPTR_MAX;
    return redcc_unit_begin(work->partition, group, points.point[place].address);
}

static void cut_beside_leader(const struct work *work, uint32_t group) {
    const struct points points = work->points_of[group];
    const struct partition *partition = work->partition;
    bool labelled = false;
    for (size_t i = 0; i < points.count; i++) {
        work->label_of_point[i] = work->label_of[points.point[i].iteration];
        labelled = labelled || work->label_of_point[i].low <= work->label_of_point[i].high;
    }
    if (!labelled)
        return; /* no iteration of the group touches the leading group, so the group keeps its
                   quantiles */
    uintptr_t *cut = redcc_cuts(partition, group);
    for (uint32_t owner = 1; owner < partition->owners; owner++)
        cut[owner] = best_cut(work, group, owner);
    close_cuts(partition, group);
}

static void cut_all(const struct work *work, size_t iterations) {
    struct partition *partition = work->partition;
    struct point *point = work->point;
    uint32_t leader = UINT32_MAX, most = 0, groups = 0;
    for (uint32_t group = 0; group < partition->array_count; group++) {
        if (!redcc_leads_group(partition, group))
            continue;
        work->points_of[group] = gather(work, group, point);
        point += work->points_of[group].count;
        sort_by_address(work->points_of[group], work->spare);
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
    label_iterations(work, leader, iterations);
    for (uint32_t group = 0; group < partition->array_count; group++)
        if (redcc_leads_group(partition, group) && group != leader)
            cut_beside_leader(work, group);
}

#ifndef NDEBUG
/* Do the cuts of each group ascend from 0 to UINTPTR_MAX? */
static bool are_cut(const struct partition *partition) {
    for (uint32_t group = 0; group < partition->array_count; group++) {
        const uintptr_t *cut = redcc_cuts(partition, group);
        bool ascending = cut[0] == 0 && cut[partition->owners] == UINTPTR_MAX;
        for (uint32_t owner = 0; owner < partition->owners; owner++)
            ascending = ascending && cut[owner] <= cut[owner + 1];
        if (redcc_leads_group(partition, group) && !ascending)
            return false;
    }
    return true;
}
#endif

bool redcc_choose_cuts(struct partition *partition, const struct sample *const *sample,
                       int threads) {
    assert(threads >= 1 && partition->owners <= partition->room);
    size_t points = 1, iterations = 1;
    for (int thread = 0; thread < threads; thread++) {
        points += sample[thread]->count;
        iterations += (size_t)sample[thread]->iterations + 1;
    }
    struct work work = {.partition = partition, .sample = sample, .threads = threads};
    work.points_of = redcc_memory_alloc(partition->array_count * sizeof *work.points_of);
    work.point = redcc_memory_alloc(points * sizeof *work.point);
    work.spare = redcc_memory_alloc(points * sizeof *work.spare);
    work.label_of = redcc_memory_alloc(iterations * sizeof *work.label_of);
    work.label_of_point = redcc_memory_alloc(points * sizeof *work.label_of_point);
    const bool enough =
        work.points_of && work.point && work.spare && work.label_of && work.label_of_point;
    if (enough)
        cut_all(&work, iterations);
    assert(!enough || are_cut(partition));
    redcc_memory_free(work.points_of);
    redcc_memory_free(work.point);
    redcc_memory_free(work.spare);
    redcc_memory_free(work.label_of);
    redcc_memory_free(work.label_of_point);
    return enough;
}
