/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The sample of the iterations, from which the cuts between the owners are chosen. */
#include "inspect/inspection.h"

#include <assert.h>

#include "base/memory.h"
#include "base/share.h"
#include "ownership/cuts.h"
#include "ownership/owner_map.h"
#include "plan/method.h"
#include "plan/tile_grid.h"

/* A map of owners chosen by votes is kept only if the largest share with the map is below this
 * fraction of the largest share with the cuts, because owner checks with a map are slower. */
#define WORTH_A_MAP 0.9

/* The iterations of a sample take at most this time, in seconds, when the loop executes them.
 * Recording them and computing estimates takes about ten times as long. (`auto` expects 0.4 ms for
 * a sample by all threads.) */
#define SAMPLED_SECONDS 25e-6

enum {
    SAMPLED_FOR_AN_OWNER = 512, /* maximum number of iterations per owner, over all threads */
    /* number of iterations per owner: the smallest sample, if time permits, and the largest one if
     * a single thread takes the sample only for an estimate */
    SAMPLED_FOR_A_LOOK = 128,
    SAMPLED_OF = 16,    /* one iteration in this many is sampled, within the other limits; a larger
                           sample of a short loop would cost more than the loop */
    LOOKED_AT_OF = 128, /* as SAMPLED_OF, for a sample that is only for an estimate. It has fewer
                           iterations, because if the trip count is small, iterations may be long */
    LOOKED_AT_LEAST = 16,            /* minimum number of iterations per owner for an estimate */
    SAMPLED_MOST = 8192,             /* maximum number of iterations */
    SAMPLED_TOUCHES = 32768,         /* number of touches kept if there are few owners */
    SAMPLED_TOUCHES_AN_OWNER = 2048, /* number of touches kept per owner if there are many owners */
    SAMPLED_TOUCHES_MOST = 4 * SAMPLED_TOUCHES, /* maximum number of touches kept */
    ROWS_OF_A_TOUCH = 64 /* maximum number of rows that are sampled of one touch */
};

/* Is the sample taken only to estimate tiles? Tiles have no owners. */
static bool is_for_tiles(const struct inspection *inspection) {
    const struct request *request = &inspection->call->request;
    return !inspection->call->method && request->loop->flags & REDCC_TILES &&
           redcc_can_be_tiled(request->trip);
}

/* The number of iterations, at most `most`, that fit into the sample's time. It is at least few /
 * 2, since few long iterations suffice for cuts: each has many touches. If iterations vote on
 * owners (ownership/owner_map.h), it is at least `few`. If the order is not serial, returns `most`,
 * because the time must not affect the result. */
static redcc_int in_time(const struct inspection *inspection, redcc_int few, redcc_int most) {
    const double usual = inspection->pace.usual;
    if (usual * (double)most <= SAMPLED_SECONDS || inspection->call->order != REDCC_ORDER_SERIAL)
        return most;
    const bool votes = inspection->call->request.loop->flags & REDCC_SELECTS;
    return redcc_min(most, redcc_max(votes ? few : few / 2, (redcc_int)(SAMPLED_SECONDS / usual)));
}

/* The stride of the sample: each `stride` consecutive iterations contain one of the sample, for any
 * number of threads. The sample is small, because sorting more touches than the owners need would
 * cost more than the sweep of all iterations. */
static redcc_int sample_stride(const struct inspection *inspection) {
    const struct partition *partition = &inspection->partition;
    const redcc_int shares = partition->owners / (1 + partition->stealable);
    const bool looks = inspection->call->threads < inspection->call->planned;
    const redcc_int trip = inspection->call->request.trip, few = shares * SAMPLED_FOR_A_LOOK;
    const redcc_int even = trip / SAMPLED_OF < few ? few : trip / SAMPLED_OF;
    const redcc_int most = redcc_min(shares * SAMPLED_FOR_AN_OWNER, SAMPLED_MOST);
    const redcc_int seen = redcc_max(shares * LOOKED_AT_LEAST, trip / LOOKED_AT_OF);
    const redcc_int wanted = is_for_tiles(inspection) ? shares * LOOKED_AT_LEAST
                             : looks                  ? redcc_min(few, seen)
                                     : in_time(inspection, few, redcc_min(even, most));
    return redcc_max(trip / wanted, 1);
}

/* The number of sampled iterations before this thread's share. */
static redcc_int sampled_before(const struct inspection *inspection,
                                const struct inspector *inspector) {
    const redcc_int stride = sample_stride(inspection);
    return (redcc_own_begin(inspection, inspector) + stride - 1) / stride;
}

/* The iteration that is number `number` of the sample: one of the `stride` iterations from
 * number * stride on. Multiples of the golden ratio, mod 1, distribute them evenly over the
 * strides. If all were at the beginning of their stride, the sample of a loop over the cells of a
 * grid might consist of a few columns or diagonals, and contain no cells at a border. */
static redcc_int sampled_at(redcc_int number, redcc_int stride, redcc_int trip) {
    const uint64_t fraction = (uint64_t)number * 0x9e3779b97f4a7c15u >> 32; /* of 2^32 */
    const redcc_int further = (redcc_int)((double)fraction * 0x1p-32 * (double)stride);
    return redcc_min(number * stride + further, trip - 1);
}

/* The number of touches to keep, over all threads: with more touches, cuts are more even. (If
 * results must not depend on the number of threads, each thread needs space for all of them, so
 * their number is smaller.) */
static size_t touches_to_keep(const struct inspection *inspection) {
    if (inspection->call->method && inspection->call->method->keeps == REDCC_ORDER_FIXED)
        return SAMPLED_TOUCHES;
    const size_t wanted = (size_t)inspection->partition.owners * SAMPLED_TOUCHES_AN_OWNER;
    const size_t most = wanted < SAMPLED_TOUCHES_MOST ? wanted : SAMPLED_TOUCHES_MOST;
    return most < SAMPLED_TOUCHES ? SAMPLED_TOUCHES : most;
}

/* The number of touches for which a thread's sample has space. If results must not depend on the
 * number of threads, it is the number of touches that may be kept in the end, because this thread's
 * share may contain all of them. */
static size_t sample_room(const struct inspection *inspection, const struct inspector *inspector) {
    const struct method *method = inspection->call->method;
    const size_t all = inspection->partition.share > 0 ? 1 : touches_to_keep(inspection);
    const size_t least = 1024, even = all / (size_t)inspector->threads;
    if (method && method->keeps == REDCC_ORDER_FIXED)
        return all;
    return even > least ? even : least;
}

static bool begin_sample(const struct inspection *inspection, struct inspector *inspector) {
    const struct partition *partition = &inspection->partition;
    inspector->entries = redcc_memory_alloc(REDCC_ENTRIES * sizeof *inspector->entries);
    inspector->seen = redcc_memory_alloc(partition->array_count * sizeof *inspector->seen);
    inspector->executed = redcc_memory_alloc_zeroed(partition->room, sizeof *inspector->executed);
    if (!redcc_sample_begin(&inspector->sample, sample_room(inspection, inspector),
                            (uint64_t)sampled_before(inspection, inspector)) ||
        !inspector->entries || !inspector->seen || !inspector->executed)
        return false;
    for (uint32_t array = 0; array < partition->array_count; array++)
        inspector->seen[array] = redcc_nowhere;
    redcc_forget_sources(inspection, inspector);
    return true;
}

void redcc_sample_start(const struct inspection *inspection, struct inspector *inspector) {
    inspector->failed = !begin_sample(inspection, inspector);
    inspector->timing = (struct slice_timing){0};
    /* the thread's own share, of which nothing is swept yet */
    inspector->next = redcc_own_begin(inspection, inspector);
    inspector->at = sampled_before(inspection, inspector);
}

bool redcc_sample_hand_out(const struct inspection *inspection, struct inspector *inspector,
                           redcc_worker *worker) {
    const redcc_int stride = sample_stride(inspection), number = inspector->at;
    assert(stride >= 1 && number >= 0);
    if (inspector->failed)
        return false;
    if (number * stride >= redcc_own_end(inspection, inspector) || inspection->partition.share > 0)
        return redcc_timing_hand_out(inspection, inspector, worker);
    const redcc_int at = sampled_at(number, stride, inspection->call->request.trip);
    inspector->at = number + 1;
    redcc_hand_out(inspector, worker, at, at + 1, 1, inspector->nowhere);
    return true;
}

/* Adds a touch that covers several rows as one touch per row, up to a limit. So the cuts, which lie
 * between rows, can divide it. */
static void sample_rows(const struct inspection *inspection, struct inspector *inspector,
                        const redcc_entry *entry) {
    const uint32_t unit = inspection->partition.arrays[entry->array].unit;
    const uint32_t rows = entry->bytes / unit > 0 ? entry->bytes / unit : 1;
    const uint32_t step = (rows + ROWS_OF_A_TOUCH - 1) / ROWS_OF_A_TOUCH;
    redcc_sample_add(&inspector->sample, (uintptr_t)entry->address, entry->array,
                     (rows + step - 1) / step, step * unit);
}

void redcc_sample_take(const struct inspection *inspection, struct inspector *inspector,
                       const redcc_entry *end) {
    if (inspector->timing.passes > 0)
        return;
    for (const redcc_entry *entry = inspector->entries; entry != end; entry++) {
        if (entry->array == REDCC_END_OF_ITERATION) {
            redcc_sample_next_iteration(&inspector->sample);
            continue;
        }
        const uintptr_t first = (uintptr_t)entry->address;
        if (entry->bytes == 0)
            continue;
        inspector->seen[entry->array] = redcc_range_union(
            inspector->seen[entry->array], (struct range){first, first + entry->bytes});
        sample_rows(inspection, inspector, entry);
    }
}

/* Called after groups were merged: for each merged group, joins the ranges that each thread has
 * touched. */
static void regroup_seen(struct inspection *inspection) {
    const struct partition *partition = &inspection->partition;
    for (int thread = 0; thread < inspection->call->threads; thread++) {
        struct range *seen = inspection->inspector[thread]->seen;
        for (uint32_t array = 0; array < partition->array_count; array++) {
            const uint32_t group = partition->group_of[array];
            if (group == array)
                continue;
            seen[group] = redcc_range_union(seen[group], seen[array]);
            seen[array] = redcc_nowhere;
        }
    }
}

/* Sets the ranges of the sources that are known before the inspection. The sweep records the
 * others. */
static void place_known_sources(struct inspection *inspection) {
    const struct request *request = &inspection->call->request;
    for (uint32_t s = 0; s < request->loop->source_count; s++)
        inspection->sources[s] = redcc_range_of(request->known[s]);
}

/* Computes owners by majority votes, for threads that find their iterations during execution. Keeps
 * the map of these owners if its estimated share is clearly better than that of the cuts
 * (WORTH_A_MAP). Sets estimate->direct. Returns false if out of memory. */
static bool compare_votes(struct inspection *inspection, struct estimate *estimate) {
    struct partition *partition = &inspection->partition;
    const int threads = inspection->call->threads;
    struct estimate voted = {.share = 1};
    estimate->direct = estimate->share;
    if (!(inspection->call->request.loop->flags & REDCC_SELECTS) || partition->owners < 2)
        return true;
    redcc_owner_map_vote(partition, inspection->touched, inspection->samples, threads);
    if (partition->map.owner && !redcc_estimate(partition, inspection->samples, threads, &voted))
        return false;
    if (voted.share < WORTH_A_MAP * estimate->share)
        estimate->direct = voted.share;
    else
        redcc_owner_map_end(&partition->map);
    return true;
}

bool redcc_cut(struct inspection *inspection, struct estimate *estimate) {
    struct partition *partition = &inspection->partition;
    const int threads = inspection->call->threads;
    regroup_seen(inspection);
    place_known_sources(inspection);
    if (partition->share > 0)
        return true;
    redcc_inspection_set_owners(inspection);
    for (int thread = 0; thread < threads; thread++)
        inspection->samples[thread] = &inspection->inspector[thread]->sample;
    redcc_owner_map_end(&partition->map);
    if (!redcc_choose_cuts(partition, inspection->samples, threads) ||
        (estimate && (!redcc_estimate(partition, inspection->samples, threads, estimate) ||
                      !compare_votes(inspection, estimate))))
        return false;
    inspection->each = estimate ? estimate->each : (struct touching){0};
    return true;
}

/* Thins the samples. Afterwards an item represents the same number of touches in each sample, and
 * all samples together have at most touches_to_keep items. */
static void thin_samples(struct inspection *inspection) {
    struct inspector *const *inspector = inspection->inspector;
    uint64_t keep_each = 1;
    size_t count = SIZE_MAX;
    for (int thread = 0; thread < inspection->call->threads; thread++)
        if (inspector[thread]->sample.keep_each > keep_each)
            keep_each = inspector[thread]->sample.keep_each;
    for (; count > touches_to_keep(inspection); keep_each *= 2) {
        count = 0;
        for (int thread = 0; thread < inspection->call->threads; thread++)
            count += redcc_sample_count(&inspector[thread]->sample, keep_each);
    }
    for (int thread = 0; thread < inspection->call->threads; thread++)
        redcc_sample_thin(&inspector[thread]->sample, keep_each / 2);
}

enum reason redcc_sample_finish(struct inspection *inspection) {
    if (redcc_inspection_failed(inspection))
        return REASON_NO_MEMORY;
    thin_samples(inspection);
    redcc_gather_touched(inspection);
    return redcc_partition_merge(&inspection->partition, inspection->touched) == MERGE_REFUSED
               ? REASON_OUT_OF_STEP
               : REASON_NONE;
}
