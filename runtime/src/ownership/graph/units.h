/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The units (rows) of all groups of a partition, numbered from 0: those of the leading group first.
 */
#ifndef REDCC_UNITS_H
#define REDCC_UNITS_H

#include "ownership/partition.h"

/** The touched units of one group, and all units between them. */
struct group_units {
    uintptr_t first; /* address of the first unit */
    uint32_t begin;  /* number of the first unit */
    uint32_t count;
    uint32_t bytes; /* of a unit */
    uint64_t reciprocal;
};

struct units {
    uint32_t leading; /* number of units of the leading group */
    uint32_t count;   /* number of units of all groups */
    bool too_many;    /* more than REDCC_UNITS_MOST: both counts are 0 */
    uint32_t array_count;
    struct group_units *of; /* [array_count] of each group; empty for other arrays */
};

/** The largest count. */
#define REDCC_UNITS_MOST 0x7ffffffeu

/** Numbers the units of the groups; group g is touched in touched[g]. False: out of memory. Call
 *  redcc_units_end in either case. */
bool redcc_units_begin(struct units *units, const struct partition *partition,
                       const struct range *touched);

/** Frees its memory. */
void redcc_units_end(struct units *units);

/** Converts an offset from a group's first unit to a number of units. */
static inline uint64_t redcc_units_in(const struct group_units *group, uint64_t offset) {
    return redcc_quotient(offset, group->bytes, group->reciprocal);
}

#endif
