/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What is read of a source to find out whether its contents are what they were. */
#ifndef REDCC_READING_H
#define REDCC_READING_H

#include "base/range.h"
#include "redcc/runtime.h"
#include "reuse/fingerprint.h"

/** Not what an earlier source (counted from 1; 0: none) has shown already, as of row_start[i] and
 *  row_start[i + 1]. How the two lie to each other is compared too. */
struct reading {
    struct range range;
    bool has_gaps; /* where it begins and ends was found by the inspection: what lies between need
                      not have been read, nor be readable */
    uint32_t beside;
    uintptr_t distance; /* from there to the source */
};

/** Of source number `source` of the loop; sources [source_count] is where they lie, known what was
 *  known of that before the inspection. */
struct reading redcc_reading_of(const redcc_loop *loop, const redcc_extent *known,
                                const struct range *sources, uint32_t source);

/** The bytes of a range. */
static inline size_t redcc_range_bytes(struct range range) {
    return redcc_range_empty(range) ? 0 : range.end - range.first;
}

static inline bool redcc_readings_equal(struct reading a, struct reading b) {
    return a.range.first == b.range.first && a.range.end == b.range.end && a.beside == b.beside &&
           a.distance == b.distance;
}

/** Of `range`, which lies in that of the reading. Of what cannot be read one that equals no other.
 */
struct fingerprint redcc_part_fingerprint(const struct reading *reading, struct range range);

/** Of all of it. */
struct fingerprint redcc_reading_fingerprint(struct reading reading);

/** Of what lies before and behind its whole pages; all of it where it has none. */
struct fingerprint redcc_reading_ends(struct reading reading);

#endif
