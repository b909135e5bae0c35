/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The overlap guard: may a loop that reads here and writes there run in parallel? */
#ifndef REDCC_OVERLAP_H
#define REDCC_OVERLAP_H

#include "base/range.h"

/** Which range that is read overlaps which one that is written. */
struct overlap {
    uint32_t source;
    uint32_t array; /* from array_count on: a scalar, by its number among the sources */
};

/** May the source be, as far as the translator knows, what number `kept` is: a scalar in memory
 * that the loop adds to, or an iteration's own element? */
static inline bool redcc_may_meet_scalar(const redcc_loop *loop, uint32_t source, uint32_t kept) {
    const int a = loop->sources[source].is_subscript, b = loop->sources[kept].is_subscript;
    const bool are_behind_one = a >= REDCC_BEHIND(1) && a / REDCC_BEHIND(1) == b / REDCC_BEHIND(1);
    return source != kept && a > 1 && (b & REDCC_IS_SCALAR) && !are_behind_one;
}

/** Does the source lie apart from all of these? */
static inline bool redcc_range_is_apart_from_scalars(const redcc_loop *loop,
                                                     const struct range *read, uint32_t source,
                                                     struct overlap *overlap) {
    for (uint32_t s = 0; s < loop->source_count; s++)
        if (redcc_may_meet_scalar(loop, source, s) && redcc_ranges_overlap(read[source], read[s])) {
            *overlap = (struct overlap){source, loop->array_count + s};
            return false;
        }
    return true;
}

/** The same of all that is known to be read before anything is executed. */
static inline bool redcc_known_are_apart_from_scalars(const redcc_loop *loop,
                                                      const redcc_extent *known,
                                                      struct overlap *overlap) {
    for (uint32_t r = 0; r < loop->source_count; r++)
        for (uint32_t s = 0; s < loop->source_count; s++)
            if (redcc_may_meet_scalar(loop, r, s) &&
                redcc_ranges_overlap(redcc_range_of(known[r]), redcc_range_of(known[s]))) {
                *overlap = (struct overlap){r, loop->array_count + s};
                return false;
            }
    return true;
}

/**
 * Does nothing that the loop reads (read [loop->source_count]) overlap anything that it writes
 * (written [written_count])? Asked for a new plan at what its inspection found, for a kept one at
 * the places where the arrays and the sources are in this call. False: *overlap is the first pair
 * that does.
 */
static inline bool redcc_ranges_are_apart(const redcc_loop *loop, const struct range *read,
                                          const struct range *written, uint32_t written_count,
                                          struct overlap *overlap) {
    for (uint32_t r = 0; r < loop->source_count; r++) {
        if (!redcc_range_is_apart_from_scalars(loop, read, r, overlap))
            return false;
        for (uint32_t w = 0; w < written_count; w++)
            if (redcc_ranges_overlap(read[r], written[w])) {
                *overlap = (struct overlap){r, w};
                return false;
            }
    }
    return true;
}

#endif
