/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/units.h"

#include <assert.h>

#include "base/memory.h"

/* The reciprocal for divisions by `bytes` (redcc_quotient); 0 if it would not be exact. It is exact
 * for units of 2 to 65535 bytes and offsets below REDCC_UNITS_MOST units. */
static uint64_t reciprocal_of(uint32_t bytes) {
    const bool exact = bytes > 1 && bytes < 1u << 16;
    return exact ? UINT64_MAX / bytes + 1 : 0;
}

/* Numbers a group's units, from `begin` on. Returns false if there are too many units. */
static bool number_group(struct group_units *group, const struct partition *partition,
                         uint32_t number, struct range touched, uint64_t begin) {
    *group =
        (struct group_units){.begin = (uint32_t)begin, .bytes = partition->arrays[number].unit};
    group->reciprocal = reciprocal_of(group->bytes);
    if (redcc_range_empty(touched))
        return true;
    group->first = redcc_unit_begin(partition, number, touched.first);
    const uint64_t count = (touched.end - 1 - group->first) / group->bytes + 1;
    if (count > REDCC_UNITS_MOST || begin + count > REDCC_UNITS_MOST)
        return false;
    group->count = (uint32_t)count;
    return true;
}

bool redcc_units_begin(struct units *units, const struct partition *partition,
                       const struct range *touched) {
    const uint32_t arrays = partition->array_count, leader = partition->leader;
    assert(leader < arrays && redcc_leads_group(partition, leader));
    *units = (struct units){.array_count = arrays};
    units->of = redcc_memory_alloc_zeroed(arrays, sizeof *units->of);
    if (!units->of)
        return false;
    bool fits = number_group(&units->of[leader], partition, leader, touched[leader], 0);
    uint64_t count = units->leading = units->of[leader].count;
    for (uint32_t group = 0; group < arrays; group++) {
        if (group == leader || !redcc_leads_group(partition, group))
            continue;
        fits = fits && number_group(&units->of[group], partition, group, touched[group], count);
        count += units->of[group].count;
    }
    units->too_many = !fits;
    units->count = fits ? (uint32_t)count : 0;
    units->leading = fits ? units->leading : 0;
    return true;
}

void redcc_units_end(struct units *units) {
    redcc_memory_free(units->of);
    *units = (struct units){0};
}
