/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Fingerprints of a thread's share of the subscripts. They are taken piece by piece while the
 * inspector goes through the thread's iterations, as far as it has come: a loop mostly reads its
 * subscripts in the order of its iterations, and so they are still in the caches.
 */
#include "loop.h"

enum { SMALL = 8192, STRIPE = 64, PIECE = 128 * 1024 };

bool redcc_is_small(struct reading reading) {
    return redcc_range_bytes(reading.range) <= SMALL;
}

/* The share's first byte, and how many they are: whole stripes but for the last one's. */
static const char *share_of(struct reading reading, const struct member *member, size_t *count) {
    const size_t bytes = redcc_range_bytes(reading.range);
    const redcc_int stripes = (redcc_int)((bytes + STRIPE - 1) / STRIPE);
    const size_t first = (size_t)redcc_share(stripes, member->threads, member->thread) * STRIPE;
    const size_t end = (size_t)redcc_share(stripes, member->threads, member->thread + 1) * STRIPE;
    *count = (end < bytes ? end : bytes) - (first < bytes ? first : bytes);
    return (const char *)reading.range.first + first;
}

/* Goes on in whole pieces to `part` of the share; 1: to its end. */
static void take_up_to(struct taking *taking, const struct member *member, double part) {
    size_t count;
    const char *const share = share_of(taking->reading, member, &count);
    const size_t wanted = part < 1 ? (size_t)((double)count * part) / PIECE * PIECE : count;
    while (taking->taken < wanted) {
        const size_t left = wanted - taking->taken, bytes = left < PIECE ? left : PIECE;
        const uintptr_t first = (uintptr_t)share + taking->taken;
        const struct range piece = {first, first + bytes};
        const struct fingerprint parts[] = {taking->so_far,
                                            redcc_part_fingerprint(&taking->reading, piece)};
        taking->so_far = redcc_fingerprint_join(parts, 2);
        taking->taken += bytes;
    }
}

struct fingerprint redcc_share_fingerprint(const struct member *member, struct reading reading) {
    struct taking taking = {.reading = reading};
    take_up_to(&taking, member, 1);
    return taking.so_far;
}

/* Is where this source lies known before the inspection? */
static bool is_taken_early(const struct execution *execution, uint32_t source) {
    const struct request *request = &execution->request;
    return request->loop->sources[source].is_subscript && request->known[source].end &&
           !redcc_is_small(
               redcc_reading_of(request->loop, request->known, execution->sources, source));
}

size_t redcc_begin_taking(struct member *member) {
    const struct execution *execution = member->execution;
    const redcc_loop *loop = execution->request.loop;
    const bool is_for_a_plan = loop->flags & REDCC_VERIFIABLE && !execution->only_timed;
    size_t bytes = 0, count;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        member->taking[s] = (struct taking){.taken = 0};
        if (!is_for_a_plan || !is_taken_early(execution, s))
            continue;
        member->taking[s].reading =
            redcc_reading_of(loop, execution->request.known, execution->sources, s);
        share_of(member->taking[s].reading, member, &count);
        bytes += count;
    }
    return bytes;
}

void redcc_take_some(struct member *member, double part) {
    const uint32_t count = member->execution->request.loop->source_count;
    for (uint32_t s = 0; s < count; s++)
        if (!redcc_range_empty(member->taking[s].reading.range))
            take_up_to(&member->taking[s], member, part);
}

void redcc_take_fingerprints(struct member *member) {
    const struct execution *execution = member->execution;
    const redcc_loop *loop = execution->request.loop;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        if (!loop->sources[s].is_subscript)
            continue;
        const struct reading reading =
            redcc_reading_of(loop, execution->request.known, execution->sources, s);
        struct taking *taking = &member->taking[s];
        if (redcc_is_small(reading)) {
            if (member->thread == 0)
                member->fingerprint[s] = redcc_reading_fingerprint(reading);
            continue;
        }
        if (!redcc_readings_equal(taking->reading, reading)) /* now it is known where all lie */
            *taking = (struct taking){.reading = reading};
        take_up_to(taking, member, 1);
        member->fingerprint[s] = taking->so_far;
    }
}
