/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Numbers the units (rows) of all groups of a partition from 0, those of the leading group first.
 */
#ifndef REDCC_UNITS_H
#define REDCC_UNITS_H

#include "ownership/partition.h"

/** The units of one group, from the first to the last touched unit. */
struct group_units {
    uintptr_t first; /* address of the first unit */
    uint32_t begin;  /* number of the first unit */
    uint32_t count;
    uint32_t bytes; /* size of a unit */
    uint64_t reciprocal;
};

struct units {
    uint32_t leading; /* number of units of the leading group */
    uint32_t count;   /* number of units of all groups */
    bool too_many;    /* there are more than REDCC_UNITS_MOST units: both counts are 0 */
    uint32_t array_count;
    struct group_units *of; /* [array_count] the units of each group; empty for arrays whose number
                               is not that of a group */
};

/** The largest possible number of units. */
#define REDCC_UNITS_MOST 0x7ffffffeu

/** Numbers the units of the groups. touched[g] is the range in which group g is touched. False: out
 * of memory. Call redcc_units_end in either case. */
bool redcc_units_begin(struct units *units, const struct partition *partition,
                       const struct range *touched);

/** Frees the memory. */
void redcc_units_end(struct units *units);

/** The number of the unit that contains the byte at `offset`. Both are counted from the group's
 * first unit. */
static inline uint64_t redcc_units_in(const struct group_units *group, uint64_t offset) {
    return redcc_quotient(offset, group->bytes, group->reciprocal);
}

#endif
