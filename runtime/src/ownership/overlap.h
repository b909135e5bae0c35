/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The overlap guard: may a loop that reads here and writes there run in parallel? */
#ifndef REDCC_OVERLAP_H
#define REDCC_OVERLAP_H

#include "base/range.h"

/** Which range that is read overlaps which one that is written. */
struct overlap {
    uint32_t source;
    uint32_t array;
};

/**
 * Does nothing that is read (read [read_count]) overlap anything that is written (written
 * [written_count])? Asked for a new plan at what its inspection found, for a kept one at the places
 * where the arrays and the sources are in this call. False: *overlap is the first pair that does.
 */
static inline bool redcc_ranges_are_apart(const struct range *read, uint32_t read_count,
                                          const struct range *written, uint32_t written_count,
                                          struct overlap *overlap) {
    for (uint32_t r = 0; r < read_count; r++)
        for (uint32_t w = 0; w < written_count; w++)
            if (redcc_ranges_overlap(read[r], written[w])) {
                *overlap = (struct overlap){r, w};
                return false;
            }
    return true;
}

#endif
