/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A reading is the part of a source that is read to check whether its contents are unchanged. */
#ifndef REDCC_READING_H
#define REDCC_READING_H

#include "base/range.h"
#include "redcc/runtime.h"
#include "reuse/fingerprint.h"

/** A reading does not include bytes that an earlier subscript source covers, as for row_start[i]
 * and row_start[i + 1]. In this case the distance between the two sources is compared, too. */
struct reading {
    struct range range;
    bool has_gaps;   /* the range comes from the inspection, so some bytes in it may not have been
                        read, and may be unreadable */
    uint32_t beside; /* 1 + the index of the earlier source; 0: none */
    uintptr_t distance; /* distance from the earlier source to this source */
};

/** The reading of source number `source` of the loop. sources[source_count] has the sources'
 * ranges; `known` tells which ranges are known before the inspection. If `sources` is NULL, only
 * the ranges in `known` are used, and the readings of all other sources are empty. */
struct reading redcc_reading_of(const redcc_loop *loop, const redcc_extent *known,
                                const struct range *sources, uint32_t source);

static inline size_t redcc_range_bytes(struct range range) {
    return redcc_range_empty(range) ? 0 : range.end - range.first;
}

static inline bool redcc_readings_equal(struct reading a, struct reading b) {
    return a.range.first == b.range.first && a.range.end == b.range.end && a.beside == b.beside &&
           a.distance == b.distance;
}

/** Computes the fingerprint of `range`, which is a part of the reading. Unreadable memory has a
 * fingerprint that equals no other. */
struct fingerprint redcc_part_fingerprint(const struct reading *reading, struct range range);

/** Computes the fingerprint of the whole reading. */
struct fingerprint redcc_reading_fingerprint(struct reading reading);

/** Computes the fingerprint of the reading's bytes that are before or after its whole pages. If it
 * has no whole pages, computes the fingerprint of the whole reading. */
struct fingerprint redcc_reading_ends(struct reading reading);

#endif
