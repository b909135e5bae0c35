/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "reuse/hashing.h"

#include "base/share.h"

#include <assert.h>

enum { SMALL = 8192, STRIPE = 64, PIECE = 128 * 1024 };

bool redcc_is_small(struct reading reading) {
    return redcc_range_bytes(reading.range) <= SMALL;
}

/* Returns the address of the thread's share of the reading, and sets *count to its number of bytes.
 * All shares except the last consist of whole stripes. */
static const char *share_of(struct reading reading, const struct hasher *hasher, size_t *count) {
    const size_t bytes = redcc_range_bytes(reading.range);
    const redcc_int stripes = (redcc_int)((bytes + STRIPE - 1) / STRIPE);
    const size_t first = (size_t)redcc_share(stripes, hasher->threads, hasher->thread) * STRIPE;
    const size_t end = (size_t)redcc_share(stripes, hasher->threads, hasher->thread + 1) * STRIPE;
    assert(first <= end && hasher->thread < hasher->threads);
    *count = (end < bytes ? end : bytes) - (first < bytes ? first : bytes);
    return (const char *)reading.range.first + first;
}

/* Continues the hash of the thread's share, in whole pieces, up to the fraction `part` of the
 * share. If `part` is 1, hashes the share to its end. */
static void hash_up_to(struct partial_hash *partial, const struct hasher *hasher, double part) {
    size_t count;
    const char *const share = share_of(partial->reading, hasher, &count);
    const size_t wanted = part < 1 ? (size_t)((double)count * part) / PIECE * PIECE : count;
    while (partial->taken < wanted) {
        const size_t left = wanted - partial->taken, bytes = left < PIECE ? left : PIECE;
        const uintptr_t first = (uintptr_t)share + partial->taken;
        const struct range piece = {first, first + bytes};
        const struct fingerprint parts[] = {partial->so_far,
                                            redcc_part_fingerprint(&partial->reading, piece)};
        partial->so_far = redcc_fingerprint_join(parts, 2);
        partial->taken += bytes;
    }
}

struct fingerprint redcc_hash_share(const struct hasher *hasher, struct reading reading) {
    assert(0 <= hasher->thread && hasher->thread < hasher->threads);
    struct partial_hash partial = {.reading = reading};
    hash_up_to(&partial, hasher, 1);
    return partial.so_far;
}

/* Is this source a subscript array whose range is known before the inspection, and which is not
 * small (redcc_is_small)? */
static bool is_hashed_early(const struct request *request, const struct range *sources,
                            uint32_t source) {
    return (request->loop->sources[source].flags & REDCC_IS_SUBSCRIPT) &&
           request->known[source].end &&
           !redcc_is_small(redcc_reading_of(request->loop, request->known, sources, source));
}

size_t redcc_hash_begin(struct hasher *hasher, const struct request *request,
                        const struct range *sources) {
    const redcc_loop *loop = request->loop;
    size_t bytes = 0, count;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        hasher->partial[s] = (struct partial_hash){.taken = 0};
        if (!(loop->flags & REDCC_VERIFIABLE) || !is_hashed_early(request, sources, s))
            continue;
        hasher->partial[s].reading = redcc_reading_of(loop, request->known, sources, s);
        share_of(hasher->partial[s].reading, hasher, &count);
        bytes += count;
    }
    return bytes;
}

void redcc_hash_some(struct hasher *hasher, const redcc_loop *loop, double part) {
    assert(0 <= part && part <= 1);
    for (uint32_t s = 0; s < loop->source_count; s++)
        if (!redcc_range_empty(hasher->partial[s].reading.range))
            hash_up_to(&hasher->partial[s], hasher, part);
}

void redcc_hash_rest(struct hasher *hasher, const struct request *request,
                     const struct range *sources) {
    const redcc_loop *loop = request->loop;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        if (!(loop->sources[s].flags & REDCC_IS_SUBSCRIPT))
            continue;
        const struct reading reading = redcc_reading_of(loop, request->known, sources, s);
        struct partial_hash *partial = &hasher->partial[s];
        if (redcc_is_small(reading)) {
            if (hasher->thread == 0)
                hasher->fingerprint[s] = redcc_reading_fingerprint(reading);
            continue;
        }
        /* the range is not the one that was hashed */
        if (!redcc_readings_equal(partial->reading, reading))
            *partial = (struct partial_hash){.reading = reading};
        hash_up_to(partial, hasher, 1);
        hasher->fingerprint[s] = partial->so_far;
    }
}

struct fingerprint redcc_hash_joined(struct hasher *const *hasher, int threads, uint32_t source,
                                     struct reading reading) {
    assert(threads >= 1);
    enum { AT_ONCE = 64 };
    struct fingerprint part[AT_ONCE + 1] = {{{reading.beside, reading.distance}}};
    int count = 1;
    for (int thread = 0; thread < threads; thread++) {
        part[count++] = hasher[thread]->fingerprint[source];
        if (count > AT_ONCE) { /* joins the shares so far, and continues with the next ones */
            part[0] = redcc_fingerprint_join(part, count);
            count = 1;
        }
    }
    return redcc_fingerprint_join(part, count);
}
