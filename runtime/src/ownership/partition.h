/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The partition of the reduction arrays' bytes among owners. Arrays that are found to overlap form
 * a group, and each group is cut into one consecutive part per owner. Owner number o owns part
 * number o of every group.
 */
#ifndef REDCC_PARTITION_H
#define REDCC_PARTITION_H

#include "base/range.h"

#include "redcc/runtime.h"
#include <assert.h>

/** Is the array scattered: are its elements at arbitrary addresses? Memory between the elements may
 * belong to other objects or be unmapped, so only touched bytes may be read or written. */
static inline bool redcc_is_scattered(const void *base) {
    return base == NULL;
}

/** The number of stealable blocks per share, if there are any. */
enum { REDCC_STEALABLE = 2 };

enum { REDCC_OWNERS_MOST = 256 }; /* maximum number of owners for a map */

/** The part of a map for the units of one group. */
struct group_map {
    ptrdiff_t first; /* offset of the first unit from the group's base */
    uint32_t begin;  /* the first unit's index in the map */
    uint32_t count;  /* number of units */
    uint32_t bytes;  /* size of a unit, which is one row or several rows */
};

struct owner_map {
    unsigned char *owner; /* NULL: there is no map */
    struct group_map *of; /* [array_count] the units of each group */
};

struct partition {
    const redcc_array *arrays; /* borrowed from the loop */
    uint32_t array_count;
    uint32_t room; /* the number of owners for which memory is allocated */
    uint32_t owners;
    /* Each 1 + stealable consecutive owners form a share. The first owner of a share has the
     * largest part. The others are stealable blocks, small parts for threads that finish early */
    uint32_t stealable;
    uintptr_t *base;    /* [array_count] the arrays' first elements */
    uint32_t *group_of; /* [array_count] the group of each array. A group's number is that of its
                           array with the largest unit */
    /* [array_count * (owners + 1)] cut[g * (owners + 1) + o] is the first address of owner o in
     * group g. The first cut of each group is 0, the last is UINTPTR_MAX */
    uintptr_t *cut;
    bool mixed;           /* the arrays of some group differ in type or operator */
    uint32_t leader;      /* the group that determines the cuts of the others */
    struct owner_map map; /* if present, the map defines the owners in place of the cuts */
    double share; /* if owners are kept for later executions: the fraction of the iterations that
                     the most loaded owner executed in the first execution; otherwise 0 */
};

/** The part of `amount` that the owners below `owner` have together. Each share has an equal part;
 * of this, the first owner has 84 %, and its stealable blocks have 10 and 6 %. Without stealable
 * blocks all owners have equal parts. */
static inline uint64_t redcc_amount_below(uint32_t owners, uint32_t stealable, uint32_t owner,
                                          uint64_t amount) {
    static const uint64_t per_thousand[1 + REDCC_STEALABLE] = {0, 840, 940};
    const uint32_t each = 1 + stealable, shares = owners / each;
    assert(owners % each == 0 && owner <= owners && stealable <= REDCC_STEALABLE);
    return (amount * (owner / each) + amount * per_thousand[owner % each] / 1000) / shares;
}

/** Makes every array a separate group, not yet cut. False: out of memory. Call redcc_partition_end
 * in either case. */
bool redcc_partition_begin(struct partition *partition, const redcc_loop *loop, void *const *bases,
                           uint32_t owners);

/** Moves the cuts of arrays that now begin at `bases`, by the same distances as the arrays. */
void redcc_partition_move(struct partition *partition, void *const *bases);

/** Gives all bytes to a single owner. To cut the partition again, set partition->owners, to at most
 * the original number. */
void redcc_partition_in_one(struct partition *partition);

/** Makes *whole a partition with one owner. *whole shares all memory with *partition except `cut`,
 * which must be freed separately. Returns false if out of memory. */
bool redcc_partition_see_whole(struct partition *whole, const struct partition *partition);

/** Merges owner o * (1 + stealable) and its stealable blocks into one owner, number o. */
void redcc_partition_join_stealable(struct partition *partition);

/** Gives every owner stealable blocks that own no addresses yet. There must be room for these
 * owners. */
void redcc_partition_add_stealable(struct partition *partition);

/** Removes the map. */
void redcc_owner_map_end(struct owner_map *map);

/** Frees the partition's memory. */
void redcc_partition_end(struct partition *partition);

/** The beginnings of the owners of group g: [owners + 1] addresses, ascending. */
static inline uintptr_t *redcc_cuts(const struct partition *partition, uint32_t group) {
    assert(group < partition->array_count);
    return partition->cut + (size_t)group * (partition->owners + 1);
}

/** Does this array's number identify its group? */
static inline bool redcc_leads_group(const struct partition *partition, uint32_t array) {
    assert(array < partition->array_count);
    return partition->group_of[array] == array;
}

enum merge_result {
    MERGE_NOTHING, /* no two groups overlap */
    MERGE_DONE,    /* groups were merged, and their cuts and ranges must be recomputed */
    MERGE_REFUSED  /* two groups overlap, but not every unit boundary of the one with larger units
                      is one of the other */
};

/** Merges groups whose ranges touched[group] overlap, and updates touched[array_count]. */
enum merge_result redcc_partition_merge(struct partition *partition, struct range *touched);

/** The owner of the byte at `address` of group `group`. */
static inline uint32_t redcc_owner_of(const struct partition *partition, uint32_t group,
                                      uintptr_t address) {
    const uintptr_t *cut = redcc_cuts(partition, group);
    uint32_t low = 0, high = partition->owners; /* cut[low] <= address < cut[high] */
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        if (cut[middle] <= address)
            low = middle;
        else
            high = middle;
    }
    assert(cut[low] <= address || low == 0);
    return low;
}

/** The beginning of the unit of group `group` that contains `address`. */
static inline uintptr_t redcc_unit_begin(const struct partition *partition, uint32_t group,
                                         uintptr_t address) {
    const uintptr_t base = partition->base[group], unit = partition->arrays[group].unit;
    if (address >= base)
        return base + (address - base) / unit * unit;
    return base - (base - address + unit - 1) / unit * unit;
}

#endif
