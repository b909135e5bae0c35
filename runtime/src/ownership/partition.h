/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Who owns which bytes: arrays that overlap form a group, each group is cut into as many
 * consecutive parts as there are owners, and part o of every group belongs to owner o.
 */
#ifndef REDCC_PARTITION_H
#define REDCC_PARTITION_H

#include "base/range.h"
#include "redcc/runtime.h"

/** Do the elements of an array with this base lie anywhere? Between the first and the last of them
 *  there may be anything, or nothing: only what was touched may be read or written. */
static inline bool redcc_is_scattered(const void *base) {
    return base == NULL;
}

/** How many stealable blocks go with each share, where there are any. */
enum { REDCC_STEALABLE = 2 };

struct partition {
    const redcc_array *arrays; /* borrowed from the loop */
    uint32_t array_count;
    uint32_t room; /* for so many owners */
    uint32_t owners;
    uint32_t stealable; /* of every 1 + stealable owners in a row the first has most, and the others
                        are stealable blocks: small parts for threads that finish early */
    uintptr_t *base;    /* [array_count] the arrays' first elements */
    uint32_t *group_of; /* [array_count] its group, called by one of the group's arrays: the one
                           with the largest unit */
    uintptr_t *cut;     /* [array_count * (owners + 1)] of group g: cut[g * (owners + 1) + o] is
                           where owner o begins; the first is 0, the last UINTPTR_MAX */
    bool mixed;         /* some group's arrays differ in type or operator */
    uint32_t leader;    /* the group that the others are cut beside */
};

/** Of `amount` to be shared out, what owners below `owner` get: each share's owner 84 %, the
 *  stealable ones behind it 10 and 6 %. Without stealable ones all get the same. */
static inline uint64_t redcc_amount_below(uint32_t owners, uint32_t stealable, uint32_t owner,
                                          uint64_t amount) {
    static const uint64_t per_thousand[1 + REDCC_STEALABLE] = {0, 840, 940};
    const uint32_t each = 1 + stealable, shares = owners / each;
    return (amount * (owner / each) + amount * per_thousand[owner % each] / 1000) / shares;
}

/** Every array a group of its own, not yet cut. False: no memory (end it all the same). */
bool redcc_partition_begin(struct partition *partition, const redcc_loop *loop, void *const *bases,
                           uint32_t owners);

/** Cuts nothing: one owner of all. It can be cut again for as many owners as it was begun for,
 * after partition->owners has been set to that. */
void redcc_partition_in_one(struct partition *partition);

/** *whole is *partition in one piece; it borrows all but `cut`, which is to be given back alone.
 *  False: no memory. */
bool redcc_partition_see_whole(struct partition *whole, const struct partition *partition);

/** Makes owners[o * (1 + stealable)] and the stealable ones behind it one owner, number o. */
void redcc_partition_join_stealable(struct partition *partition);

/** Cuts nothing off: every owner gets stealable ones behind it, which have nothing by address.
 * There is room for them. */
void redcc_partition_add_stealable(struct partition *partition);

/** Gives back its memory. */
void redcc_partition_end(struct partition *partition);

/** Where the owners of group g begin: [owners + 1] addresses, ascending. */
static inline uintptr_t *redcc_cuts(const struct partition *partition, uint32_t group) {
    return partition->cut + (size_t)group * (partition->owners + 1);
}

/** Is this array the one its group is called by? */
static inline bool redcc_leads_group(const struct partition *partition, uint32_t array) {
    return partition->group_of[array] == array;
}

enum merge_result {
    MERGE_NOTHING, /* no two groups overlap */
    MERGE_DONE,    /* some were put together: their cuts and ranges are to be found anew */
    MERGE_REFUSED  /* some overlap in such a way that no cut is safe for both */
};

/** Puts groups together that overlap in touched[group]. touched [array_count] is updated. */
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
    return low;
}

/** The begin of the unit of group `group` that holds `address`. */
static inline uintptr_t redcc_unit_begin(const struct partition *partition, uint32_t group,
                                         uintptr_t address) {
    const uintptr_t base = partition->base[group], unit = partition->arrays[group].unit;
    if (address >= base)
        return base + (address - base) / unit * unit;
    return base - (base - address + unit - 1) / unit * unit;
}

#endif
