/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/fences.h"

#include "base/memory.h"
#include "ownership/overlap.h"

#include <assert.h>

enum {
    LEAST_ROOM = 1 << 16,  /* least number of bytes by which a range is extended on each side, if
                            * nothing else is there */
    MOST_WANTED = 1 << 10, /* greatest number of inspections that are required after failures */
};

bool redcc_fences_new(struct fences *fences, const redcc_loop *loop) {
    const size_t arrays = loop->array_count, sources = loop->source_count;
    *fences =
        (struct fences){.of = redcc_memory_alloc_zeroed(arrays + sources, sizeof *fences->of),
                        .allowed = redcc_memory_alloc_zeroed(arrays, sizeof *fences->allowed),
                        .updates = redcc_memory_alloc_zeroed(arrays, sizeof *fences->updates),
                        .reads = redcc_memory_alloc_zeroed(sources + 1, sizeof *fences->reads)};
    return fences->of && fences->allowed && fences->updates && fences->reads;
}

void redcc_fences_free(struct fences *fences) {
    redcc_memory_free(fences->of);
    redcc_memory_free(fences->allowed);
    redcc_memory_free(fences->updates);
    redcc_memory_free(fences->reads);
}

void redcc_fences_learn(struct fences *fences, const redcc_loop *loop, void *const *bases,
                        const redcc_extent *known, const struct range *touched,
                        const struct range *read) {
    for (uint32_t a = 0; a < loop->array_count; a++)
        fences->of[a] = (struct fenced){bases[a], touched[a]};
    for (uint32_t s = 0; s < loop->source_count; s++)
        fences->of[loop->array_count + s] = (struct fenced){known[s].first, read[s]};
    fences->are_new = !fences->are_known;
    fences->are_known = true;
    fences->inspections++;
}

void redcc_fences_fail(struct fences *fences) {
    fences->are_known = false;
    fences->inspections = 0;
    fences->wanted = fences->wanted < MOST_WANTED ? 2 * fences->wanted + 1 : MOST_WANTED;
}

/* ---- fences of an execution ------------------------------------------------------------------ */

/* A range that an inspection found, moved with its array or source to the present address, and the
 * free space around the range. */
struct yard {
    struct range seen, free;
    bool is_exact; /* the source's range is known, so it is not extended */
};

static struct yard yard_of(const struct fences *fences, const redcc_loop *loop, void *const *bases,
                           const redcc_extent *known, uint32_t i) {
    const struct fenced *it = &fences->of[i];
    struct yard yard = {it->seen, {1, UINTPTR_MAX}, false};
    const redcc_extent extent =
        i < loop->array_count ? (redcc_extent){bases[i], NULL} : known[i - loop->array_count];
    if (extent.end)
        return (struct yard){redcc_range_of(extent), redcc_range_of(extent), true};
    if (extent.first && it->base && !redcc_range_empty(yard.seen)) {
        const uintptr_t by = (uintptr_t)extent.first - (uintptr_t)it->base;
        yard.seen = (struct range){yard.seen.first + by, yard.seen.end + by};
    }
    return yard;
}

/* Must the ranges i and k be disjoint? They are numbered as in fences->of. */
static bool may_not_meet(const redcc_loop *loop, uint32_t i, uint32_t k) {
    const uint32_t arrays = loop->array_count;
    if (i < arrays)
        return k < arrays || redcc_source_meets_arrays(loop, k - arrays);
    return k < arrays ? redcc_source_meets_arrays(loop, i - arrays)
                      : redcc_may_meet_scalar(loop, i - arrays, k - arrays) ||
                            redcc_may_meet_scalar(loop, k - arrays, i - arrays);
}

/* Bounds the free space of a range by another range with which it must not overlap. The two spaces
 * end at the same address: at the edge of `other` if that is exact, otherwise in the middle. */
static void bound(struct yard *yard, const struct yard *other) {
    const struct range seen = yard->seen, far = other->seen;
    if (redcc_range_empty(far))
        return;
    if (far.first >= seen.end) {
        const uintptr_t half = (far.first - seen.end) / 2;
        const uintptr_t end = other->is_exact ? far.first : seen.end + half;
        yard->free.end = end < yard->free.end ? end : yard->free.end;
    } else {
        const uintptr_t half = (seen.first - far.end) / 2;
        const uintptr_t first = other->is_exact ? far.end : far.end + half;
        yard->free.first = first > yard->free.first ? first : yard->free.first;
    }
}

/* Extends the range on each side by its own length, or LEAST_ROOM if that is more, as far as the
 * free space permits. */
static struct range with_room(const struct yard *yard) {
    const size_t size = redcc_range_size(yard->seen), room = size > LEAST_ROOM ? size : LEAST_ROOM;
    const uintptr_t before = yard->seen.first - yard->free.first;
    const uintptr_t behind = yard->free.end - yard->seen.end;
    return (struct range){yard->seen.first - (before < room ? before : room),
                          yard->seen.end + (behind < room ? behind : room)};
}

/* Finds the fence of array or source i. Returns false if there is none. */
static bool find_fence(const struct fences *fences, const redcc_loop *loop, void *const *bases,
                       const redcc_extent *known, uint32_t i, struct range *fence) {
    struct yard yard = yard_of(fences, loop, bases, known, i);
    if (!yard.is_exact && (redcc_range_empty(yard.seen) || yard.seen.first == 0))
        return false;
    for (uint32_t k = 0; k < loop->array_count + loop->source_count; k++) {
        if (k == i || !may_not_meet(loop, i, k))
            continue;
        const struct yard other = yard_of(fences, loop, bases, known, k);
        if (redcc_ranges_overlap(yard.seen, other.seen))
            return false;
        if (!yard.is_exact)
            bound(&yard, &other);
    }
    *fence = yard.is_exact ? yard.seen : with_room(&yard);
    return true;
}

static redcc_owner owner_of(struct range range) {
    return (redcc_owner){.first = (const char *)range.first, .size = range.end - range.first};
}

static redcc_extent extent_of(struct range range) {
    return (redcc_extent){(const char *)range.first, (const char *)range.end};
}

void redcc_fences_open(struct fences *fences, const redcc_loop *loop) {
    fences->stand = fences->are_new = false;
    for (uint32_t a = 0; a < loop->array_count; a++)
        fences->updates[a] = owner_of((struct range){0, UINTPTR_MAX});
    for (uint32_t s = 0; s < loop->source_count; s++)
        fences->reads[s] = extent_of((struct range){0, UINTPTR_MAX});
}

static bool set_all(struct fences *fences, const redcc_loop *loop, void *const *bases,
                    const redcc_extent *known) {
    for (uint32_t a = 0; a < loop->array_count; a++) {
        if (!find_fence(fences, loop, bases, known, a, &fences->allowed[a]))
            return false;
        fences->updates[a] = owner_of(fences->allowed[a]);
    }
    for (uint32_t s = 0; s < loop->source_count; s++) {
        struct range fence;
        if (!find_fence(fences, loop, bases, known, loop->array_count + s, &fence))
            return false;
        fences->reads[s] = extent_of(fence);
    }
    return true;
}

bool redcc_fences_set(struct fences *fences, const redcc_loop *loop, void *const *bases,
                      const redcc_extent *known) {
    assert(redcc_may_be_fenced(loop) && !fences->stand);
    if (!fences->are_known || fences->inspections < fences->wanted)
        return false;
    fences->stand = set_all(fences, loop, bases, known);
    if (!fences->stand)
        redcc_fences_open(fences, loop);
    return fences->stand;
}
