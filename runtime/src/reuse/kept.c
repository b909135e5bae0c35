/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "reuse/kept.h"

#include "base/aliases.h"
#include "base/clock.h"
#include "base/memory.h"
#include "ownership/overlap.h"

#include <assert.h>
#include <string.h>

/* ---- does a plan fit? ------------------------------------------------------------------------ */

/* Sets sources[source_count] to the sources' ranges in this call. Returns false if this call gives
 * the ranges of other sources than the call for which the plan was built, or ranges of other
 * lengths. */
static bool sources_fit(const struct kept_plan *kept, const struct request *request,
                        struct range *sources) {
    for (uint32_t s = 0; s < request->loop->source_count; s++) {
        const struct source_record *record = &kept->source[s];
        const redcc_extent known = request->known[s];
        const uintptr_t anchor = (uintptr_t)known.first;
        if (record->known != (known.end != NULL) || record->anchored != (anchor != 0))
            return false;
        if (record->known && known.end - known.first != record->extent.end)
            return false;
        sources[s] = redcc_nowhere;
        if (record->extent.first < record->extent.end)
            sources[s] = (struct range){anchor + (uintptr_t)record->extent.first,
                                        anchor + (uintptr_t)record->extent.end};
    }
    return true;
}

static struct range place_of(const struct plan *plan, const struct request *request,
                             uint32_t array) {
    const struct offsets touched = plan->touched[array];
    if (plan->group_of[array] != array || touched.first >= touched.end)
        return redcc_nowhere;
    const uintptr_t base = (uintptr_t)request->bases[array];
    return (struct range){base + (uintptr_t)touched.first, base + (uintptr_t)touched.end};
}

/* Are the arrays' relative positions those for which the plan was built? The arrays of a group must
 * have the same distances, and groups must be disjoint. Sets written[array_count] to the groups'
 * ranges in this call. */
static bool arrays_fit(const struct plan *plan, const struct request *request,
                       struct range *written) {
    for (uint32_t a = 0; a < plan->array_count; a++) {
        const uintptr_t group = (uintptr_t)request->bases[plan->group_of[a]];
        if ((ptrdiff_t)((uintptr_t)request->bases[a] - group) != plan->shift[a])
            return false;
        written[a] = place_of(plan, request, a);
        for (uint32_t b = 0; b < a; b++)
            if (redcc_ranges_overlap(written[a], written[b]))
                return false;
    }
    return true;
}

static bool fits(const struct reuse *reuse, const struct kept_plan *kept, int threads) {
    const struct request *request = &reuse->call->request;
    const redcc_loop *loop = request->loop;
    const struct plan *plan = kept->plan;
    const size_t key_bytes = loop->key_count * sizeof *kept->key;
    struct overlap overlap;
    return plan->trip == request->trip && plan->threads == threads &&
           redcc_float_control_equal(kept->float_control, reuse->call->float_control) &&
           (key_bytes == 0 || memcmp(kept->key, request->key, key_bytes) == 0) &&
           sources_fit(kept, request, reuse->sources) &&
           arrays_fit(plan, request, reuse->written) &&
           redcc_ranges_are_disjoint(loop, reuse->sources, reuse->written, plan->array_count,
                                     &overlap);
}

static struct reading reading_of(const struct reuse *reuse, uint32_t source) {
    return redcc_reading_of(reuse->call->request.loop, reuse->call->request.known, reuse->sources,
                            source);
}

static void ask_tracking(struct reuse *reuse) {
    const redcc_loop *loop = reuse->call->request.loop;
    double earned = reuse->earned;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        struct tracking *tracking = &reuse->found->source[s].tracking;
        tracking->is_untouched = false;
        tracking->begun = 0;
        if ((loop->sources[s].flags & REDCC_IS_SUBSCRIPT) && reuse->call->tracks)
            redcc_tracking_ask(tracking, reading_of(reuse, s), &reuse->cache->back_off, &earned);
    }
}

/* ---- samples --------------------------------------------------------------------------------- */

/* SplitMix64 (Steele, Lea, Flood 2014). */
static uint64_t mixed(uint64_t hash, uint64_t word) {
    hash = (hash ^ word) + 0x9e3779b97f4a7c15u;
    hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ hash >> 27) * 0x94d049bb133111ebu;
    return hash ^ hash >> 31;
}

/* A hash of a few words of a subscript array. 0 if the source is no subscript array, or if the call
 * does not give its range or the range is shorter than a word. */
static uint64_t sample_source(redcc_source source, redcc_extent known) {
    enum { WORDS = 32 }; /* reading 32 words takes some 3 microseconds if none is in the caches */
    uint64_t hash = 0;
    if (!(source.flags & REDCC_IS_SUBSCRIPT) || !known.end ||
        known.end - known.first < (ptrdiff_t)sizeof(uint64_t))
        return 0;
    const size_t last = (size_t)(known.end - known.first) - sizeof(uint64_t);
    for (size_t word = 0; word < WORDS; word++) {
        uint64_t held;
        memcpy(&held, known.first + last / (WORDS - 1) * word, sizeof held);
        hash = mixed(hash, held);
    }
    return hash;
}

uint64_t redcc_reuse_sample(const redcc_loop *loop, const redcc_extent *known) {
    uint64_t hash = 0;
    if (!(loop->flags & REDCC_VERIFIABLE) && loop->flags & REDCC_DRY_RUN)
        return 0; /* an iteration may leave the loop before the end of the range, which then need
                   * not be readable */
    for (uint32_t s = 0; s < loop->source_count; s++) {
        const uint64_t sampled = sample_source(loop->sources[s], known[s]);
        hash = sampled ? mixed(hash, sampled) : hash;
    }
    return hash;
}

/* The first source whose sample differs from the sample when the plan was built; -1: none. */
static int changed_source(const struct reuse *reuse, const struct kept_plan *kept) {
    const struct request *request = &reuse->call->request;
    for (uint32_t s = 0; s < request->loop->source_count; s++)
        if (kept->source[s].sampled != sample_source(request->loop->sources[s], request->known[s]))
            return (int)s;
    return -1;
}

/* ---- the search ------------------------------------------------------------------------------ */

static unsigned bit_of(const struct kept_plan *kept) {
    return 1u << redcc_way_of(kept->plan->method);
}

void redcc_reuse_survey(struct reuse *reuse, int threads, unsigned *fits_now, unsigned *changed) {
    assert(threads >= 1 && reuse->changed_source < 0);
    struct kept_plan *newest = NULL; /* the plan used most recently */
    *fits_now = *changed = 0;
    for (int p = 0; p < REDCC_PLANS; p++) {
        struct kept_plan *kept = reuse->cache->kept[p];
        if (!kept || !fits(reuse, kept, threads))
            continue;
        const bool same = kept->sampled == reuse->sampled;
        *(same ? fits_now : changed) |= bit_of(kept);
        if (!same && (!newest || newest->last_use < kept->last_use))
            newest = kept;
    }
    *changed &= ~*fits_now;
    if (*fits_now || !newest || newest->stale)
        return;
    newest->stale = true;
    reuse->changed_source = changed_source(reuse, newest);
}

/* Finds the plan that was used most recently, if several plans have the same sample. */
void redcc_reuse_find(struct reuse *reuse, int threads, enum way way) {
    struct plan_cache *cache = reuse->cache;
    struct kept_plan *found = NULL;
    for (int p = 0; p < REDCC_PLANS; p++) {
        struct kept_plan *kept = cache->kept[p];
        if (kept && (way == WAY_SEQUENTIAL || bit_of(kept) == 1u << way) &&
            kept->sampled == reuse->sampled && (!found || found->last_use < kept->last_use) &&
            fits(reuse, kept, threads))
            found = kept;
    }
    reuse->found = found;
    /* fits is called again, because it also sets reuse->sources and reuse->written */
    if (!found || !fits(reuse, found, threads))
        return;
    if (redcc_may_be_aliased(
            (struct touches){reuse->written, found->plan->array_count, reuse->sources,
                             reuse->call->request.loop->source_count, reuse->call->request.loop})) {
        redcc_reuse_drop_found(reuse);
        return;
    }
    assert(found->plan->array_count == reuse->call->request.loop->array_count);
    found->last_use = ++cache->clock;
    found->stale = false;
    found->plan->round++;
    ask_tracking(reuse);
}

/* Does the source begin inside of a source whose range is known? */
static bool is_part_of_another(const redcc_loop *loop, const redcc_extent *known, uint32_t source) {
    const uintptr_t first = (uintptr_t)known[source].first;
    for (uint32_t s = 0; s < loop->source_count; s++)
        if (known[s].end && (uintptr_t)known[s].first <= first && first < (uintptr_t)known[s].end)
            return true;
    return false;
}

/* Adds the hash of the bytes to *all. Returns false if the time `until` was exceeded. */
static bool take_in(struct fingerprint *all, const char *data, size_t bytes, double until) {
    enum { PIECE = 256 * 1024 };
    for (size_t done = 0; done < bytes; done += PIECE) {
        const size_t left = bytes - done;
        const struct fingerprint parts[] = {
            *all, redcc_fingerprint(data + done, left < PIECE ? left : PIECE)};
        if (redcc_seconds() > until)
            return false;
        *all = redcc_fingerprint_join(parts, 2);
    }
    return true;
}

/* Does the call give the ranges of all subscript arrays, or of sources that contain them? */
static bool are_known(const redcc_loop *loop, const redcc_extent *known) {
    for (uint32_t s = 0; s < loop->source_count; s++)
        if ((loop->sources[s].flags & REDCC_IS_SUBSCRIPT) && !known[s].end &&
            !is_part_of_another(loop, known, s))
            return false;
    return true;
}

bool redcc_reuse_fingerprint(const redcc_loop *loop, const redcc_extent *known, double seconds,
                             struct fingerprint *all) {
    const double until = redcc_seconds() + seconds;
    *all = redcc_fingerprint(NULL, 0);
    if (!(loop->flags & REDCC_VERIFIABLE) || !are_known(loop, known))
        return false;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        if (!(loop->sources[s].flags & REDCC_IS_SUBSCRIPT))
            continue;
        const struct reading reading = redcc_reading_of(loop, known, NULL, s);
        const struct fingerprint parts[] = {*all, {{reading.beside, reading.distance}}};
        *all = redcc_fingerprint_join(parts, 2);
        if (!take_in(all, (const char *)reading.range.first, redcc_range_bytes(reading.range),
                     until))
            return false;
    }
    return true;
}

/* ---- are a plan's subscripts unchanged? -------------------------------------------------------
 */

/* All threads together compare a source. The range of the next source may depend on the contents of
 * this one. So no thread reads the next one before all threads have found this one unchanged.
 * Returns whether it is. */
static bool verify_together(struct reuse *reuse, struct hasher *hasher, uint32_t source) {
    const struct reading reading = reading_of(reuse, source);
    hasher->fingerprint[source] = redcc_hash_share(hasher, reading);
    if (redcc_barrier_arrive(reuse->barrier, hasher->threads)) {
        reuse->same = redcc_fingerprint_equal(
            redcc_hash_joined(reuse->hasher, hasher->threads, source, reading),
            reuse->found->source[source].fingerprint);
        redcc_barrier_release(reuse->barrier);
    }
    return reuse->same;
}

static bool verify_alone(const struct reuse *reuse, uint32_t source) {
    return redcc_fingerprint_equal(redcc_reading_fingerprint(reading_of(reuse, source)),
                                   reuse->found->source[source].fingerprint);
}

/* Compares a source by reading it, and returns whether it is unchanged. Only the first thread
 * writes data for later calls; no other thread reads these data in this call. */
static bool verify_by_reading(struct reuse *reuse, struct hasher *hasher, uint32_t source) {
    const bool same = redcc_is_small(reading_of(reuse, source))
                          ? verify_alone(reuse, source)
                          : verify_together(reuse, hasher, source);
    if (same && hasher->thread == 0)
        redcc_tracking_stable(&reuse->found->source[source].tracking, reading_of(reuse, source),
                              reuse->skipped_calls);
    return same;
}

bool redcc_reuse_verify(struct reuse *reuse, struct hasher *hasher) {
    assert(reuse->found && hasher->threads == reuse->call->threads);
    const redcc_loop *loop = reuse->call->request.loop;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        if (!(loop->sources[s].flags & REDCC_IS_SUBSCRIPT))
            continue;
        const struct tracking *tracking = &reuse->found->source[s].tracking;
        const bool same = tracking->is_untouched
                              ? redcc_tracking_unchanged(tracking, reading_of(reuse, s))
                              : verify_by_reading(reuse, hasher, s);
        if (same)
            continue;
        if (hasher->thread == 0)
            reuse->changed_source = (int)s;
        return false;
    }
    return true;
}

uint32_t redcc_reuse_skipped_sources(const struct reuse *reuse) {
    uint32_t count = 0;
    for (uint32_t s = 0; reuse->found && s < reuse->call->request.loop->source_count; s++)
        count += reuse->found->source[s].tracking.is_untouched;
    return count;
}

/* ---- keeping and dropping -------------------------------------------------------------------- */

bool redcc_is_reusable(const struct request *request, const struct range *sources) {
    if (!(request->loop->flags & REDCC_VERIFIABLE))
        return false;
    for (uint32_t s = 0; s < request->loop->source_count; s++) {
        const redcc_extent known = request->known[s];
        if (!known.end && !known.first && !redcc_range_empty(sources[s]))
            return false; /* the source's range in a later call could not be determined */
    }
    return true;
}

static void drop(struct kept_plan *kept) {
    if (!kept)
        return;
    redcc_plan_free(kept->plan);
    redcc_memory_free(kept->key);
    redcc_memory_free(kept->source);
    redcc_memory_free(kept);
}

static void record_sources(struct source_record *records, const struct reuse *reuse) {
    const struct request *request = &reuse->call->request;
    for (uint32_t s = 0; s < request->loop->source_count; s++) {
        struct source_record *record = &records[s];
        const struct range range = reuse->sources[s];
        const uintptr_t anchor = (uintptr_t)request->known[s].first;
        record->known = request->known[s].end != NULL;
        record->anchored = anchor != 0;
        if (!redcc_range_empty(range))
            record->extent = (struct offsets){(ptrdiff_t)(range.first - anchor),
                                              (ptrdiff_t)(range.end - anchor)};
        if (!(request->loop->sources[s].flags & REDCC_IS_SUBSCRIPT))
            continue;
        const struct reading reading = reading_of(reuse, s);
        record->sampled = sample_source(request->loop->sources[s], request->known[s]);
        record->fingerprint =
            redcc_is_small(reading)
                ? reuse->hasher[0]->fingerprint[s]
                : redcc_hash_joined(reuse->hasher, reuse->call->threads, s, reading);
    }
}

static struct kept_plan *record(const struct reuse *reuse) {
    const struct request *request = &reuse->call->request;
    struct kept_plan *kept = redcc_memory_alloc_zeroed(1, sizeof *kept);
    if (!kept)
        return NULL;
    const size_t key_bytes = request->loop->key_count * sizeof *kept->key;
    kept->key = redcc_memory_alloc(key_bytes);
    kept->source = redcc_memory_alloc_zeroed(request->loop->source_count, sizeof *kept->source);
    if (!kept->key || !kept->source) {
        drop(kept);
        return NULL;
    }
    if (key_bytes)
        memcpy(kept->key, request->key, key_bytes);
    kept->float_control = reuse->call->float_control;
    record_sources(kept->source, reuse);
    return kept;
}

bool redcc_reuse_keep(struct reuse *reuse, struct plan *plan) {
    struct plan_cache *cache = reuse->cache;
    assert(!reuse->found && plan->threads == reuse->call->threads);
    assert(plan->trip == reuse->call->request.trip);
    struct kept_plan *kept = record(reuse);
    if (!kept)
        return false;
    int place = 0;
    for (int p = 1; p < REDCC_PLANS; p++)
        if (cache->kept[place] &&
            (!cache->kept[p] || cache->kept[p]->last_use < cache->kept[place]->last_use))
            place = p;
    drop(cache->kept[place]);
    cache->kept[place] = kept;
    kept->plan = plan;
    kept->sampled = reuse->sampled;
    kept->last_use = ++cache->clock;
    return true;
}

static void drop_place(struct plan_cache *cache, int place) {
    drop(cache->kept[place]);
    cache->kept[place] = NULL;
}

void redcc_reuse_drop_found(struct reuse *reuse) {
    for (int p = 0; reuse->found && p < REDCC_PLANS; p++)
        if (reuse->cache->kept[p] == reuse->found)
            drop_place(reuse->cache, p);
    reuse->found = NULL;
}

void redcc_cache_drop_all(struct plan_cache *cache) {
    for (int p = 0; p < REDCC_PLANS; p++)
        drop_place(cache, p);
}
