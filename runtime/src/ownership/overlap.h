/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef REDCC_GUARD_H
#define REDCC_GUARD_H

#include "ownership/partition.h"

/**
 * The guard: may the loop run in parallel? Not where something that it reads (sources
 * [source_count]) overlaps what it updates (touched [array_count], those of groups; the others
 * empty). Returns true where nothing does; else sets *source and *array to a pair that overlaps.
 */
static inline bool redcc_guard(const struct range *sources, uint32_t source_count,
                               const struct range *touched, uint32_t array_count, uint32_t *source,
                               uint32_t *array) {
    for (*source = 0; *source < source_count; ++*source)
        for (*array = 0; *array < array_count; ++*array)
            if (redcc_ranges_overlap(sources[*source], touched[*array]))
                return false;
    return true;
}

#endif
