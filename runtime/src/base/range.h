/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Ranges of bytes, by address or by offset. */
#ifndef REDCC_RANGE_H
#define REDCC_RANGE_H

#include "redcc/runtime.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Addresses [first, end); empty if end <= first. */
struct range {
    uintptr_t first;
    uintptr_t end;
};

/** Bytes [first, end) as offsets from the base of a group of arrays (ownership/partition.h). */
struct offsets {
    ptrdiff_t first;
    ptrdiff_t end;
};

static const struct range redcc_nowhere = {UINTPTR_MAX, 0};

static inline bool redcc_range_empty(struct range range) {
    return range.end <= range.first;
}

/** The range of an extent; empty if the extent is not known yet (end == 0). */
static inline struct range redcc_range_of(redcc_extent extent) {
    return extent.end ? (struct range){(uintptr_t)extent.first, (uintptr_t)extent.end}
                      : redcc_nowhere;
}

/** The number of bytes. */
static inline size_t redcc_range_size(struct range range) {
    return redcc_range_empty(range) ? 0 : range.end - range.first;
}

static inline bool redcc_ranges_overlap(struct range a, struct range b) {
    return !redcc_range_empty(a) && !redcc_range_empty(b) && a.first < b.end && b.first < a.end;
}

/** The smallest range that contains both ranges. */
static inline struct range redcc_range_union(struct range a, struct range b) {
    return (struct range){a.first < b.first ? a.first : b.first, a.end > b.end ? a.end : b.end};
}

#endif
