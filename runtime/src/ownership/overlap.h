/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The overlap guard: may a loop with these reads and writes run in parallel? Its callers:
 *     inspect/sweeping.c   a new plan: ranges that the inspection recorded
 *     reuse/kept.c         a kept plan: the current ranges of sources and arrays
 *     bins/guard.c         bins: after the iterations of a round, before their updates are applied
 *     pipeline.c           scalars and own elements: extents known before an execution
 */
#ifndef REDCC_OVERLAP_H
#define REDCC_OVERLAP_H

#include "base/range.h"

/** If a range that the loop reads overlaps a range that it writes, identifies the two. */
struct overlap {
    uint32_t source;
    uint32_t array; /* if below array_count: the number of an array. Otherwise array_count + s,
                       where source s is a scalar accumulator or an own element */
};

/** May the source overlap a reduction array? False if the translator proved that it does not. */
static inline bool redcc_source_meets_arrays(const redcc_loop *loop, uint32_t source) {
    return !(loop->sources[source].flags & REDCC_OVERLAPS_NO_ARRAY);
}

/** Must the source be compared with scalars (REDCC_IS_SCALAR)? True if it has a flag other than
 * REDCC_IS_SUBSCRIPT. */
static inline bool redcc_may_overlap_scalars(const redcc_loop *loop, uint32_t source) {
    return loop->sources[source].flags > REDCC_IS_SUBSCRIPT;
}

/** May source `source` overlap source `kept`, if `kept` is a scalar accumulator in memory or an
 * iteration's own element? False if `kept` is neither, if the two are the same source, or if the
 * translator proved that they are disjoint. */
static inline bool redcc_may_meet_scalar(const redcc_loop *loop, uint32_t source, uint32_t kept) {
    const int a = loop->sources[source].flags, b = loop->sources[kept].flags;
    const bool are_behind_one =
        a >= REDCC_SCALAR_BASE(1) && a / REDCC_SCALAR_BASE(1) == b / REDCC_SCALAR_BASE(1);
    return source != kept && redcc_may_overlap_scalars(loop, source) && (b & REDCC_IS_SCALAR) &&
           !are_behind_one;
}

/** Are source `source` (range `read`) and the scalar `kept` (range `scalar`) disjoint, by proof or
 * by their addresses? If not, sets *overlap to this pair. */
static inline bool redcc_are_disjoint(const redcc_loop *loop, uint32_t source, struct range read,
                                      uint32_t kept, struct range scalar, struct overlap *overlap) {
    if (!redcc_may_meet_scalar(loop, source, kept) || !redcc_ranges_overlap(read, scalar))
        return true;
    *overlap = (struct overlap){source, loop->array_count + kept};
    return false;
}

/** Is the source disjoint from all scalars and own elements? If not, sets *overlap to the first
 * pair that overlaps. Most sources need no comparison. */
static inline bool redcc_range_is_disjoint_from_scalars(const redcc_loop *loop,
                                                        const struct range *read, uint32_t source,
                                                        struct overlap *overlap) {
    const bool may_meet = redcc_may_overlap_scalars(loop, source);
    for (uint32_t s = 0; may_meet && s < loop->source_count; s++)
        if (!redcc_are_disjoint(loop, source, read[source], s, read[s], overlap))
            return false;
    return true;
}

/** As redcc_range_is_disjoint_from_scalars, for all sources, but only with the extents that are
 * known before the execution. */
static inline bool redcc_known_are_disjoint_from_scalars(const redcc_loop *loop,
                                                         const redcc_extent *known,
                                                         struct overlap *overlap) {
    for (uint32_t r = 0; r < loop->source_count; r++) {
        const bool may_meet = redcc_may_overlap_scalars(loop, r);
        for (uint32_t s = 0; may_meet && s < loop->source_count; s++)
            if (!redcc_are_disjoint(loop, r, redcc_range_of(known[r]), s, redcc_range_of(known[s]),
                                    overlap))
                return false;
    }
    return true;
}

/**
 * Is everything that the loop reads (read[loop->source_count]) disjoint from everything that it
 * writes (written[written_count])? If not, sets *overlap to the first pair that overlaps, and
 * returns false.
 */
static inline bool redcc_ranges_are_disjoint(const redcc_loop *loop, const struct range *read,
                                             const struct range *written, uint32_t written_count,
                                             struct overlap *overlap) {
    for (uint32_t r = 0; r < loop->source_count; r++) {
        if (!redcc_range_is_disjoint_from_scalars(loop, read, r, overlap))
            return false;
        for (uint32_t w = 0; redcc_source_meets_arrays(loop, r) && w < written_count; w++)
            if (redcc_ranges_overlap(read[r], written[w])) {
                *overlap = (struct overlap){r, w};
                return false;
            }
    }
    return true;
}

#endif
