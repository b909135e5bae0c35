/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/partition.h"

#include "base/memory.h"

#include <assert.h>

bool redcc_partition_begin(struct partition *partition, const redcc_loop *loop, void *const *bases,
                           uint32_t owners) {
    const uint32_t count = loop->array_count;
    assert(count > 0 && owners >= 1);
    *partition = (struct partition){
        .arrays = loop->arrays, .array_count = count, .room = owners, .owners = owners};
    partition->base = redcc_memory_alloc(count * sizeof *partition->base);
    partition->group_of = redcc_memory_alloc(count * sizeof *partition->group_of);
    partition->cut = redcc_memory_alloc_zeroed((size_t)count * (owners + 1), sizeof(uintptr_t));
    if (!partition->base || !partition->group_of || !partition->cut)
        return false;
    for (uint32_t array = 0; array < count; array++) {
        partition->base[array] = (uintptr_t)bases[array];
        partition->group_of[array] = array;
    }
    return true;
}

void redcc_partition_move(struct partition *partition, void *const *bases) {
    assert(partition->owners <= partition->room);
    for (uint32_t array = 0; array < partition->array_count; array++) {
        uintptr_t *cut = redcc_cuts(partition, array);
        for (uint32_t owner = 1; owner < partition->owners; owner++)
            if (cut[owner] != 0 && cut[owner] != UINTPTR_MAX)
                cut[owner] += (uintptr_t)bases[array] - partition->base[array];
        partition->base[array] = (uintptr_t)bases[array];
    }
}

void redcc_partition_in_one(struct partition *partition) {
    assert(partition->room >= 1);
    partition->owners = 1;
    partition->stealable = 0;
    for (uint32_t group = 0; group < partition->array_count; group++) {
        redcc_cuts(partition, group)[0] = 0;
        redcc_cuts(partition, group)[1] = UINTPTR_MAX;
    }
}

bool redcc_partition_see_whole(struct partition *whole, const struct partition *partition) {
    uintptr_t *cut = redcc_memory_alloc((size_t)partition->array_count * 2 * sizeof *cut);
    *whole = *partition;
    whole->cut = cut;
    whole->map = (struct owner_map){0};
    if (cut)
        redcc_partition_in_one(whole);
    return cut != NULL;
}

void redcc_partition_join_stealable(struct partition *partition) {
    assert(partition->owners % (1 + partition->stealable) == 0);
    const uint32_t each = 1 + partition->stealable, joined = partition->owners / each;
    uintptr_t *to = partition->cut;
    for (uint32_t group = 0; group < partition->array_count; group++) {
        const uintptr_t *cut = redcc_cuts(partition, group);
        for (uint32_t owner = 0; owner <= joined; owner++)
            *to++ = cut[(size_t)owner * each]; /* in place: writes never pass reads */
    }
    partition->owners = joined;
    partition->stealable = 0;
}

void redcc_partition_add_stealable(struct partition *partition) {
    assert(partition->stealable == 0 &&
           partition->owners * (1 + REDCC_STEALABLE) <= partition->room);
    const uint32_t shares = partition->owners, each = 1 + REDCC_STEALABLE;
    for (uint32_t group = partition->array_count; group-- > 0;) {
        const uintptr_t *from = redcc_cuts(partition, group);
        uintptr_t *to = partition->cut + (size_t)group * (shares * each + 1);
        uintptr_t next = to[(size_t)shares * each] = from[shares];
        /* the copy is in place, so it goes backwards */
        for (uint32_t share = shares; share-- > 0;) {
            const uintptr_t first = from[share];
            for (uint32_t block = 1; block < each; block++)
                to[(size_t)share * each + block] = next;
            next = to[(size_t)share * each] = first;
        }
    }
    partition->owners = shares * each;
    partition->stealable = REDCC_STEALABLE;
}

void redcc_owner_map_end(struct owner_map *map) {
    redcc_memory_free(map->owner);
    redcc_memory_free(map->of);
    *map = (struct owner_map){0};
}

void redcc_partition_end(struct partition *partition) {
    redcc_owner_map_end(&partition->map);
    redcc_memory_free(partition->base);
    redcc_memory_free(partition->group_of);
    redcc_memory_free(partition->cut);
    *partition = (struct partition){0};
}

/* Is every boundary between units of `large` also a boundary between units of `small`? */
static bool in_step(const struct partition *partition, uint32_t large, uint32_t small) {
    const uintptr_t from = partition->base[large], to = partition->base[small];
    const uintptr_t apart = from > to ? from - to : to - from;
    const uint32_t unit = partition->arrays[small].unit;
    return partition->arrays[large].unit % unit == 0 && apart % unit == 0;
}

static bool put_together(struct partition *partition, uint32_t a, uint32_t b) {
    const redcc_array *arrays = partition->arrays;
    const uint32_t lead = arrays[b].unit > arrays[a].unit ? b : a;
    for (uint32_t array = 0; array < partition->array_count; array++) {
        const uint32_t group = partition->group_of[array];
        if (group != a && group != b)
            continue;
        if (!in_step(partition, lead, array))
            return false;
        partition->group_of[array] = lead;
    }
    if (arrays[a].type != arrays[b].type || arrays[a].operation != arrays[b].operation ||
        arrays[a].element != arrays[b].element || arrays[a].limit != arrays[b].limit)
        partition->mixed = true;
    return true;
}

enum merge_result redcc_partition_merge(struct partition *partition, struct range *touched) {
    enum merge_result result = MERGE_NOTHING;
    const uint32_t count = partition->array_count;
    for (uint32_t a = 0; a < count; a++)
        for (uint32_t b = a + 1; b < count; b++) {
            if (!redcc_leads_group(partition, a) || !redcc_leads_group(partition, b) ||
                !redcc_ranges_overlap(touched[a], touched[b]))
                continue;
            const struct range both = redcc_range_union(touched[a], touched[b]);
            if (!put_together(partition, a, b))
                return MERGE_REFUSED;
            touched[a] = touched[b] = redcc_nowhere;
            touched[partition->group_of[a]] = both;
            result = MERGE_DONE;
            a = 0; /* the union may overlap other groups: start over */
            b = 0;
        }
    return result;
}
